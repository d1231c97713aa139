#include "LosTopos/mesh/measures.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "Base/lists/erase_repeated.h"

namespace lostopos {

std::array<Vec3, 3> corners(const SurfaceMesh& mesh, Triangle t) {
  const auto& v = mesh.vertices(t);
  return {mesh.position(v[0]), mesh.position(v[1]), mesh.position(v[2])};
}

Vec3 area_vector(const SurfaceMesh& mesh, Triangle t) {
  const auto [a, b, c] = corners(mesh, t);
  return 0.5 * (b - a).cross(c - a);
}

double area(const SurfaceMesh& mesh, Triangle t) {
  return area_vector(mesh, t).norm();
}

Vec3 barycentre(const SurfaceMesh& mesh, Triangle t) {
  const auto [a, b, c] = corners(mesh, t);
  return (a + b + c) / 3.0;
}

double length(const SurfaceMesh& mesh, Edge e) {
  const auto& v = mesh.vertices(e);
  return (mesh.position(v[1]) - mesh.position(v[0])).norm();
}

double mean_edge_length(const SurfaceMesh& mesh) {
  double sum = 0;
  for (Edge e : mesh.edges()) sum += length(mesh, e);
  return mesh.edge_count() == 0 ? 0 : sum / static_cast<double>(mesh.edge_count());
}

double total_area(const SurfaceMesh& mesh) {
  double sum = 0;
  for (Triangle t : mesh.triangles()) sum += area(mesh, t);
  return sum;
}

double total_area(const SurfaceMesh& mesh, std::span<const Vec3> positions) {
  double sum = 0;
  for (Triangle t : mesh.triangles()) {
    const auto& [a, b, c] = mesh.vertices(t);
    const Vec3& x = positions[a.index()];
    sum += (positions[b.index()] - x).cross(positions[c.index()] - x).norm() / 2;
  }
  return sum;
}

Vec3 surface_centroid(const SurfaceMesh& mesh) {
  // Relative to one of the vertices: a surface far from the origin keeps its digits.
  Vec3 origin = Vec3::Zero(), moment = Vec3::Zero();
  double sum = 0;
  bool first = true;
  for (Triangle t : mesh.triangles()) {
    if (first) origin = mesh.position(mesh.vertices(t)[0]);
    first = false;
    const double a = area(mesh, t);
    sum += a;
    moment += a * (barycentre(mesh, t) - origin);
  }
  return sum > 0 ? Vec3(origin + moment / sum) : origin;
}

double largest_volume_drift(const std::vector<RegionVolume>& now, const std::vector<RegionVolume>& start) {
  double largest = 0;
  for (const RegionVolume& before : start) {
    if (before.region == air || before.volume == 0) continue;
    const auto it = std::ranges::lower_bound(now, before.region, {}, &RegionVolume::region);
    if (it == now.end() || it->region != before.region) continue;
    largest = std::max(largest, std::abs(it->volume / before.volume - 1));
  }
  return largest;
}

std::vector<RegionVolume> closed_region_volumes(const SurfaceMesh& mesh) {
  std::vector<Region> open;
  for (Edge e : mesh.edges()) {
    if (mesh.triangles(e).size() != 1) continue;
    const Labels labels = mesh.labels(mesh.triangles(e)[0]);
    open.insert(open.end(), {labels.p, labels.q});
  }
  std::ranges::sort(open);
  std::vector<RegionVolume> volumes = region_volumes(mesh);
  std::erase_if(volumes, [&open](const RegionVolume& v) { return std::ranges::binary_search(open, v.region); });
  return volumes;
}

std::vector<Region> regions(const SurfaceMesh& mesh) {
  std::vector<Region> found;
  found.reserve(2 * mesh.triangle_count());
  for (Triangle t : mesh.triangles()) {
    found.push_back(mesh.labels(t).p);
    found.push_back(mesh.labels(t).q);
  }
  base::sort_unique(found);
  return found;
}

std::vector<RegionVolume> region_volumes(const SurfaceMesh& mesh) {
  std::vector<RegionVolume> volumes;
  for (Region r : regions(mesh)) volumes.push_back({r, 0.0});
  auto volume_of = [&volumes](Region r) -> double& {
    return std::ranges::lower_bound(volumes, r, {}, &RegionVolume::region)->volume;
  };
  const Vec3 origin = surface_centroid(mesh);
  for (Triangle t : mesh.triangles()) {
    const auto [a, b, c] = corners(mesh, t);
    const double tetrahedron = (a - origin).dot((b - origin).cross(c - origin)) / 6.0;
    volume_of(mesh.labels(t).p) += tetrahedron;
    volume_of(mesh.labels(t).q) -= tetrahedron;
  }
  return volumes;
}

long euler_characteristic(const SurfaceMesh& mesh) {
  return static_cast<long>(mesh.vertex_count()) - static_cast<long>(mesh.edge_count()) +
         static_cast<long>(mesh.triangle_count());
}

std::size_t open_edge_count(const SurfaceMesh& mesh) {
  return static_cast<std::size_t>(
      std::ranges::count_if(mesh.edges(), [&](Edge e) { return mesh.triangles(e).size() == 1; }));
}

std::size_t junction_edge_count(const SurfaceMesh& mesh) {
  return static_cast<std::size_t>(std::ranges::count_if(mesh.edges(), [&](Edge e) { return mesh.is_junction(e); }));
}

}  // namespace lostopos
