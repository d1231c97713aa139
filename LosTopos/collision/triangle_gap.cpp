#include "LosTopos/collision/triangle_gap.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

#include "LosTopos/geometry/distance.h"

namespace lostopos {
namespace {

// Squares between these keep their digits; where they do not, nothing is certified.
constexpr double smallest_square = 0x1p-900;
constexpr double largest_square = 0x1p+900;

// Whether the points are all at least `distance` behind the plane through `base` (n may have any length).
template <class... Points>
bool are_behind(const Vec3& n, const Vec3& base, double distance, const Points&... points) {
  const double highest = std::max({n.dot(points - base)...});
  const double square = distance * distance * n.squaredNorm();
  return highest < 0 && highest * highest >= square && square > smallest_square && square < largest_square;
}

// Whether a plane that touches t has all of the points at least `distance` beyond it.
template <class... Points>
bool are_outside(const PlacedTriangle& t, double distance, const Points&... points) {
  for (std::size_t i = 0; i < 3; ++i)
    if (are_behind(t.inward[i], t.x[(i + 1) % 3], distance, points...)) return true;
  return are_behind(t.normal, t.x[0], distance, points...) || are_behind(-t.normal, t.x[0], distance, points...);
}

// Whether all of the points are at least `distance` away from the line through t's side opposite to corner i, on the
// triangle's side of it.
template <class... Points>
bool are_across(const PlacedTriangle& t, std::size_t i, double distance, const Points&... points) {
  return are_behind(-t.inward[i], t.x[(i + 1) % 3], distance, points...);
}

bool point_is_near(const Vec3& p, const PlacedTriangle& t, double distance) {
  return point_triangle_distance(p, t.x[0], t.x[1], t.x[2]).distance < distance;
}

bool edges_are_near(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, double distance) {
  return segment_segment_distance(a, b, c, d).distance < distance;
}

bool disjoint_are_near(const PlacedTriangle& t, const PlacedTriangle& u, double distance) {
  if (are_outside(u, distance, t.x[0], t.x[1], t.x[2])) return false;
  for (std::size_t i = 0; i < 3; ++i) {
    if (point_is_near(t.x[i], u, distance) || point_is_near(u.x[i], t, distance)) return true;
    for (std::size_t j = 0; j < 3; ++j)
      if (edges_are_near(t.x[i], t.x[(i + 1) % 3], u.x[j], u.x[(j + 1) % 3], distance)) return true;
  }
  return false;
}

// Whether t's side opposite to its corner i, which is u's corner j, may be near u.
bool side_is_near(const PlacedTriangle& t, std::size_t i, const PlacedTriangle& u, std::size_t j, double distance) {
  const Vec3 &b = t.x[(i + 1) % 3], &c = t.x[(i + 2) % 3];
  const Vec3 &a = u.x[j], &d = u.x[(j + 1) % 3], &e = u.x[(j + 2) % 3];
  if (are_across(t, i, distance, a, d, e) || are_outside(u, distance, b, c)) return false;
  return point_is_near(b, u, distance) || point_is_near(c, u, distance) || edges_are_near(b, c, a, d, distance) ||
         edges_are_near(b, c, a, e, distance) || edges_are_near(b, c, d, e, distance);
}

// With a common vertex: t's corner i is u's corner j.
bool fans_are_near(const PlacedTriangle& t, std::size_t i, const PlacedTriangle& u, std::size_t j, double distance) {
  return side_is_near(t, i, u, j, distance) || side_is_near(u, j, t, i, distance);
}

// With a common edge: t's corner i is opposite to it, and so is u's corner j.
bool wings_are_near(const PlacedTriangle& t, std::size_t i, const PlacedTriangle& u, std::size_t j, double distance) {
  const Vec3 &c = t.x[i], &d = u.x[j];
  if (!are_outside(u, distance, c) && point_is_near(c, u, distance)) return true;
  if (!are_outside(t, distance, d) && point_is_near(d, t, distance)) return true;
  // The side of t from c to an end of the common edge, against that of u from d to the other end.
  for (std::size_t end : {(i + 1) % 3, (i + 2) % 3}) {
    const std::size_t other = 3 - i - end;
    const std::size_t u_end = u.names[(j + 1) % 3] == t.names[end] ? (j + 1) % 3 : (j + 2) % 3;
    const Vec3 &a = t.x[end], &b = t.x[other];
    if (are_across(t, other, distance, b, d) || are_across(u, u_end, distance, a, c)) continue;
    if (edges_are_near(a, c, b, d, distance)) return true;
  }
  return false;
}

}  // namespace

PlacedTriangle placed_triangle(const SurfaceMesh& mesh, Triangle t, std::span<const Vec3> places) {
  PlacedTriangle placed;
  placed.names = mesh.vertices(t);
  for (std::size_t i = 0; i < 3; ++i) placed.x[i] = places[placed.names[i].index()];
  placed.normal = (placed.x[1] - placed.x[0]).cross(placed.x[2] - placed.x[0]);
  for (std::size_t i = 0; i < 3; ++i)
    placed.inward[i] = placed.normal.cross(placed.x[(i + 2) % 3] - placed.x[(i + 1) % 3]);
  return placed;
}

bool is_beyond(const PlacedTriangle& t, const SurfaceMesh& mesh, Triangle u, std::span<const Vec3> places,
               double distance) {
  const auto& [a, b, c] = mesh.vertices(u);
  return are_outside(t, distance, places[a.index()], places[b.index()], places[c.index()]);
}

bool have_near_elements(const PlacedTriangle& t, const PlacedTriangle& u, double distance) {
  std::array<std::pair<std::size_t, std::size_t>, 3> common;
  std::size_t count = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      if (t.names[i] == u.names[j]) common[count++] = {i, j};
  if (count == 0) return disjoint_are_near(t, u, distance);
  if (count == 1) return fans_are_near(t, common[0].first, u, common[0].second, distance);
  if (count == 3) return false;
  return wings_are_near(t, 3 - common[0].first - common[1].first, u, 3 - common[0].second - common[1].second, distance);
}

}  // namespace lostopos
