#include "LosTopos/topology/near_pairs.h"

#include <algorithm>
#include <cmath>

#include "Base/lists/erase_repeated.h"
#include "LosTopos/collision/contact_search.h"
#include "LosTopos/geometry/distance.h"

namespace lostopos {
namespace {

bool has(const std::array<Vertex, 3>& corners, Vertex v) {
  return corners[0] == v || corners[1] == v || corners[2] == v;
}

void sort_nearest_first(std::vector<NearPair>& pairs) {
  std::ranges::sort(pairs, [](const NearPair& a, const NearPair& b) {
    return a.distance != b.distance ? a.distance < b.distance : a.pair < b.pair;
  });
  base::erase_repeated(pairs, &NearPair::pair);
}

Box edge_box(const SurfaceMesh& mesh, Edge e) {
  const Vec3 &a = mesh.position(mesh.vertices(e)[0]), &b = mesh.position(mesh.vertices(e)[1]);
  return {a.cwiseMin(b), a.cwiseMax(b)};
}

Box grown(Box box, double margin) {
  box.low.array() -= margin;
  box.high.array() += margin;
  return box;
}

// Lists the near pairs between two triangles.
class PairsOfTriangles {
 public:
  PairsOfTriangles(const SurfaceMesh& mesh, double distance, std::vector<NearPair>& found)
      : mesh_(mesh), distance_(distance), found_(found) {}

  void look(Triangle t, Triangle u) {
    vertices_against(t, u);
    vertices_against(u, t);
    for (Edge e : mesh_.edges(t))
      for (Edge f : mesh_.edges(u)) edges(e, f);
  }

 private:
  void vertices_against(Triangle t, Triangle u) {
    const auto& corners = mesh_.vertices(u);
    const Box box = grown(triangle_box(mesh_, u, mesh_.positions(), 0), distance_);
    for (Vertex v : mesh_.vertices(t)) {
      const Vec3& x = mesh_.position(v);
      if (has(corners, v) || !box.overlaps({x, x})) continue;
      take({ElementPair::Kind::vertex_triangle, v.index(), u.index(), {v, corners[0], corners[1], corners[2]}});
    }
  }

  void edges(Edge e, Edge f) {
    if (e == f) return;
    const auto [first, second] = std::minmax(e, f);
    const auto &a = mesh_.vertices(first), &b = mesh_.vertices(second);
    if (a[0] == b[0] || a[0] == b[1] || a[1] == b[0] || a[1] == b[1]) return;
    if (!grown(edge_box(mesh_, e), distance_).overlaps(edge_box(mesh_, f))) return;
    take({ElementPair::Kind::edge_edge, first.index(), second.index(), {a[0], a[1], b[0], b[1]}});
  }

  void take(const ElementPair& pair) {
    const NearPair near = measured(mesh_, pair);
    if (near.distance < distance_) found_.push_back(near);
  }

  const SurfaceMesh& mesh_;
  double distance_;
  std::vector<NearPair>& found_;
};

}  // namespace

NearPair measured(const SurfaceMesh& mesh, const ElementPair& pair) {
  const auto at = [&](std::size_t i) -> const Vec3& { return mesh.position(pair.vertices[i]); };
  if (pair.kind == ElementPair::Kind::vertex_triangle) {
    const PointTriangleDistance d = point_triangle_distance(at(0), at(1), at(2), at(3));
    return {d.distance, pair, {1, d.weights[0], d.weights[1], d.weights[2]}};
  }
  const SegmentSegmentDistance d = segment_segment_distance(at(0), at(1), at(2), at(3));
  return {d.distance, pair, {1 - d.s, d.s, 1 - d.t, d.t}};
}

std::vector<NearPair> near_pairs(const SurfaceMesh& mesh, double distance, NearTriangles* near) {
  Motion at_rest(mesh, mesh.positions(), {});
  MoveStatistics unused;
  ContactSearch search(mesh, at_rest, distance, unused, near);
  std::vector<NearPair> found;
  for (const Contact& contact : search.all().proximities) {
    NearPair pair{0, contact.pair, {}};
    Vec3 offset = Vec3::Zero();
    for (std::size_t i = 0; i < 4; ++i) {
      pair.weights[i] = std::abs(contact.weights[i]);
      offset += contact.weights[i] * mesh.position(contact.pair.vertices[i]);
    }
    pair.distance = offset.norm();
    found.push_back(pair);
  }
  sort_nearest_first(found);
  return found;
}

std::vector<NearPair> near_pairs(const SurfaceMesh& mesh, SurfaceIndex& index, std::span<const Triangle> triangles,
                                 double distance) {
  std::vector<NearPair> found;
  std::vector<Triangle> nearby;
  PairsOfTriangles pairs(mesh, distance, found);
  for (Triangle t : triangles) {
    index.near(t, distance, nearby);
    for (Triangle u : nearby)
      if (u != t) pairs.look(t, u);
  }
  sort_nearest_first(found);
  return found;
}

}  // namespace lostopos
