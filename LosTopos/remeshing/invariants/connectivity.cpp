#include "LosTopos/remeshing/invariants/connectivity.h"

#include <algorithm>

#include "LosTopos/remeshing/vertex_rank.h"

namespace lostopos {
namespace {

bool has(const std::array<Vertex, 3>& corners, Vertex v) {
  return corners[0] == v || corners[1] == v || corners[2] == v;
}

// The two other vertices of t.
std::array<Vertex, 2> opposite_pair(const SurfaceMesh& mesh, Triangle t, Vertex v) {
  const auto& c = mesh.vertices(t);
  return c[0] == v ? std::array{c[1], c[2]} : c[1] == v ? std::array{c[2], c[0]} : std::array{c[0], c[1]};
}

bool has_triangle(const SurfaceMesh& mesh, Vertex v, const std::array<Vertex, 2>& pair) {
  return std::ranges::any_of(
      mesh.triangles(v), [&](Triangle t) { return has(mesh.vertices(t), pair[0]) && has(mesh.vertices(t), pair[1]); });
}

}  // namespace

bool meets_link_condition(const SurfaceMesh& mesh, Edge e) {
  const auto [a, b] = mesh.vertices(e);
  std::size_t common = 0;
  for (Edge f : mesh.edges(a)) {
    const Vertex c = mesh.other_vertex(f, a);
    if (c != b && mesh.find_edge(c, b).valid()) ++common;
  }
  // The vertices opposite to e are common neighbours, and all different.
  if (common != mesh.triangles(e).size()) return false;
  return std::ranges::none_of(mesh.triangles(a), [&, a = a, b = b](Triangle t) {
    return !has(mesh.vertices(t), b) && has_triangle(mesh, b, opposite_pair(mesh, t, a));
  });
}

bool keeps_junctions(const SurfaceMesh& mesh, Edge e) {
  const auto [a, b] = mesh.vertices(e);
  const VertexRank rank_a = rank(mesh, a), rank_b = rank(mesh, b);
  if (!is_border(mesh, e)) return rank_a == VertexRank::film || rank_b == VertexRank::film;
  if (rank_a == VertexRank::corner && rank_b == VertexRank::corner) return false;
  for (Edge f : mesh.edges(a)) {
    if (f == e || !is_border(mesh, f)) continue;
    const Edge third = mesh.find_edge(mesh.other_vertex(f, a), b);
    if (third.valid() && is_border(mesh, third)) return false;
  }
  return true;
}

}  // namespace lostopos
