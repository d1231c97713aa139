#include "FoamSim/sheet/surface_geometry.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "LosTopos/mesh/for_each_living.h"
#include "LosTopos/mesh/measures.h"

namespace foamsim {

using lostopos::Edge;
using lostopos::Labels;
using lostopos::Region;
using lostopos::SurfaceMesh;
using lostopos::Triangle;
using lostopos::Vec3;
using lostopos::Vertex;

namespace {

using SortedRegions = boost::container::small_vector<Region, 8>;

SortedRegions regions_of(const SurfaceMesh& mesh, std::span<const Triangle> triangles) {
  SortedRegions found;
  auto add = [&found](Region r) {
    const auto it = std::ranges::lower_bound(found, r);
    if (it == found.end() || *it != r) found.insert(it, r);
  };
  for (Triangle t : triangles) {
    add(mesh.labels(t).p);
    add(mesh.labels(t).q);
  }
  return found;
}

void to_offsets(std::vector<std::size_t>& counts_then_offsets) {
  std::size_t sum = 0;
  for (std::size_t& entry : counts_then_offsets) {
    const std::size_t count = entry;
    entry = sum;
    sum += count;
  }
}

}  // namespace

double signed_dihedral_angle(const SurfaceMesh& mesh, Edge e, Region r, std::span<const Vec3> unit_normals) {
  // Seen from outside of r, one of its two triangles runs along the edge and the other against it.
  Vec3 along = Vec3::Zero(), against = Vec3::Zero();
  int found_along = 0, found_against = 0;
  for (Triangle t : mesh.triangles(e)) {
    const Labels labels = mesh.labels(t);
    if (!labels.has(r)) continue;
    const bool outward = labels.p == r;
    const Vec3 normal = outward ? unit_normals[t.index()] : Vec3(-unit_normals[t.index()]);
    if (mesh.runs_along(t, e) == outward) {
      along = normal;
      ++found_along;
    } else {
      against = normal;
      ++found_against;
    }
  }
  if (found_along != 1 || found_against != 1) return 0.0;
  const auto& ends = mesh.vertices(e);
  const Vec3 direction = (mesh.position(ends[1]) - mesh.position(ends[0])).normalized();
  return std::atan2(along.cross(against).dot(direction), along.dot(against));
}

void SurfaceGeometry::update(const SurfaceMesh& mesh, std::span<const std::uint8_t> solid) {
  list_regions(mesh);
  measure_triangles(mesh, solid);
  measure_edges(mesh);
}

void SurfaceGeometry::list_regions(const SurfaceMesh& mesh) {
  vertex_begin_.assign(mesh.vertex_slots() + 1, 0);
  edge_begin_.assign(mesh.edge_slots() + 1, 0);
  lostopos::for_each_vertex(mesh,
                            [&](Vertex v) { vertex_begin_[v.index()] = regions_of(mesh, mesh.triangles(v)).size(); });
  lostopos::for_each_edge(mesh, [&](Edge e) { edge_begin_[e.index()] = regions_of(mesh, mesh.triangles(e)).size(); });
  to_offsets(vertex_begin_);
  to_offsets(edge_begin_);
  vertex_regions_.resize(vertex_begin_.back());
  edge_curvatures_.resize(edge_begin_.back());
  lostopos::for_each_vertex(mesh, [&](Vertex v) {
    std::ranges::copy(regions_of(mesh, mesh.triangles(v)), vertex_regions_.begin() + vertex_begin_[v.index()]);
  });
  lostopos::for_each_edge(mesh, [&](Edge e) {
    std::size_t i = edge_begin_[e.index()];
    for (Region r : regions_of(mesh, mesh.triangles(e))) edge_curvatures_[i++] = {r, 0.0};
  });
}

void SurfaceGeometry::measure_triangles(const SurfaceMesh& mesh, std::span<const std::uint8_t> solid) {
  areas_.assign(mesh.triangle_slots(), 0.0);
  normals_.resize(mesh.triangle_slots());
  lostopos::for_each_triangle(mesh, [&](Triangle t) {
    const Vec3 vector = lostopos::area_vector(mesh, t);
    areas_[t.index()] = vector.norm();
    normals_[t.index()] = areas_[t.index()] > 0 ? Vec3(vector / areas_[t.index()]) : Vec3(Vec3::Zero());
  });
  total_area_ = 0;
  for (Triangle t : mesh.triangles())
    if (!is_solid(t, solid)) total_area_ += areas_[t.index()];
}

void SurfaceGeometry::measure_edges(const SurfaceMesh& mesh) {
  lengths_.assign(mesh.edge_slots(), 0.0);
  lostopos::for_each_edge(mesh, [&](Edge e) {
    lengths_[e.index()] = lostopos::length(mesh, e);
    for (std::size_t i = edge_begin_[e.index()]; i != edge_begin_[e.index() + 1]; ++i) {
      RegionEdgeCurvature& entry = edge_curvatures_[i];
      entry.kappa = lengths_[e.index()] * signed_dihedral_angle(mesh, e, entry.region, normals_);
    }
  });
  double sum = 0;
  for (double length : lengths_) sum += length;
  mean_edge_length_ = mesh.edge_count() == 0 ? 0.0 : sum / static_cast<double>(mesh.edge_count());
}

}  // namespace foamsim
