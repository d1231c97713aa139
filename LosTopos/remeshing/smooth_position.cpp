#include "LosTopos/remeshing/smooth_position.h"

#include <boost/container/small_vector.hpp>
#include <cmath>
#include <numbers>

#include "LosTopos/remeshing/vertex_rank.h"

namespace lostopos {
namespace {

using Ring = boost::container::small_vector<Vertex, 16>;

// The neighbours of v in the order of the fan, from the far end of `first` on; empty when v is not within a film.
Ring ring_around(const SurfaceMesh& mesh, Vertex v, Edge first) {
  Ring ring;
  Edge edge = first;
  Triangle last;
  const std::size_t degree = mesh.edges(v).size();
  for (std::size_t i = 0; i < degree; ++i) {
    if (is_border(mesh, edge)) return {};
    const auto around = mesh.triangles(edge);
    const Triangle next = around[0] == last ? around[1] : around[0];
    ring.push_back(mesh.other_vertex(edge, v));
    for (Edge candidate : mesh.edges(next))
      if (candidate != edge && mesh.opposite_vertex(next, candidate) != v) {
        edge = candidate;
        break;
      }
    last = next;
    if (edge == first) break;
  }
  if (edge != first || ring.size() != degree) return {};
  return ring;
}

// The stencil of a vertex of valence other than six: weights of its neighbours, the new vertex's edge first.
double irregular_weight(std::size_t valence, std::size_t j) {
  if (valence == 3) return j == 0 ? 5.0 / 12 : -1.0 / 12;
  if (valence == 4) return j == 0 ? 3.0 / 8 : j == 2 ? -1.0 / 8 : 0;
  const double angle = 2 * std::numbers::pi * static_cast<double>(j) / static_cast<double>(valence);
  return (0.25 + std::cos(angle) + 0.5 * std::cos(2 * angle)) / static_cast<double>(valence);
}

Vec3 irregular_position(const SurfaceMesh& mesh, Vertex v, const Ring& ring) {
  Vec3 sum = 0.75 * mesh.position(v);
  for (std::size_t j = 0; j < ring.size(); ++j) sum += irregular_weight(ring.size(), j) * mesh.position(ring[j]);
  return sum;
}

// Both ends have six neighbours; the rings start with the other end.
Vec3 regular_position(const SurfaceMesh& mesh, const Ring& around_a, const Ring& around_b) {
  auto x = [&mesh](Vertex v) -> const Vec3& { return mesh.position(v); };
  return 0.5 * (x(around_a[0]) + x(around_b[0])) + 0.125 * (x(around_a[1]) + x(around_a[5])) -
         0.0625 * (x(around_a[2]) + x(around_a[4]) + x(around_b[2]) + x(around_b[4]));
}

std::optional<Vec3> unless_far(const SurfaceMesh& mesh, Edge e, const Vec3& position) {
  constexpr double farthest = 0.25;
  const Vec3 &a = mesh.position(mesh.vertices(e)[0]), &b = mesh.position(mesh.vertices(e)[1]);
  if (!((position - 0.5 * (a + b)).norm() <= farthest * (b - a).norm())) return {};
  return position;
}

// The border's next vertex beyond `end` as seen from e, if the border just goes on there.
std::optional<Vec3> next_on_border(const SurfaceMesh& mesh, Edge e, Vertex end) {
  if (rank(mesh, end) != VertexRank::border) return {};
  const auto [first, second] = border_edges(mesh, end).first;
  return mesh.position(mesh.other_vertex(first == e ? second : first, end));
}

}  // namespace

std::optional<Vec3> butterfly_position(const SurfaceMesh& mesh, Edge e) {
  if (is_border(mesh, e)) return {};
  const auto [a, b] = mesh.vertices(e);
  const Ring around_a = ring_around(mesh, a, e), around_b = ring_around(mesh, b, e);
  if (around_a.size() < 3 || around_b.size() < 3) return {};
  const bool regular_a = around_a.size() == 6, regular_b = around_b.size() == 6;
  if (regular_a && regular_b) return unless_far(mesh, e, regular_position(mesh, around_a, around_b));
  if (regular_a) return unless_far(mesh, e, irregular_position(mesh, b, around_b));
  if (regular_b) return unless_far(mesh, e, irregular_position(mesh, a, around_a));
  return unless_far(mesh, e, 0.5 * (irregular_position(mesh, a, around_a) + irregular_position(mesh, b, around_b)));
}

std::optional<Vec3> border_position(const SurfaceMesh& mesh, Edge e) {
  const auto [a, b] = mesh.vertices(e);
  const Vec3 &xa = mesh.position(a), &xb = mesh.position(b);
  const double length = (xb - xa).norm();
  struct Knot {
    double s;
    Vec3 x;
  };
  boost::container::small_vector<Knot, 4> knots = {{0, xa}, {length, xb}};
  if (const auto before = next_on_border(mesh, e, a)) knots.push_back({-(xa - *before).norm(), *before});
  if (const auto after = next_on_border(mesh, e, b)) knots.push_back({length + (*after - xb).norm(), *after});
  if (knots.size() == 2) return {};
  // Lagrange's form of the interpolating polynomial.
  Vec3 middle = Vec3::Zero();
  for (const Knot& knot : knots) {
    double weight = 1;
    for (const Knot& other : knots)
      if (&other != &knot) weight *= (0.5 * length - other.s) / (knot.s - other.s);
    middle += weight * knot.x;
  }
  return unless_far(mesh, e, middle);
}

}  // namespace lostopos
