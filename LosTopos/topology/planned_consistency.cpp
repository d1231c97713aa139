#include "LosTopos/topology/planned_consistency.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <cmath>

#include "LosTopos/geometry/predicates.h"

namespace lostopos {
namespace {

struct Turned {
  double angle;
  Region before, after;
};

// The corners of t in cyclic order from place `first`.
Corners from(const PlannedTriangle& t, std::size_t first) {
  return {t.corners[first], t.corners[(first + 1) % 3], t.corners[(first + 2) % 3]};
}

std::size_t place(const PlannedTriangle& t, Vertex v) {
  return static_cast<std::size_t>(std::ranges::find(t.vertices, v) - t.vertices.begin());
}

bool are_apart(const PlannedTriangle& a, const PlannedTriangle& b) {
  boost::container::small_vector<Vertex, 3> common;
  for (Vertex v : a.vertices)
    if (place(b, v) < 3) common.push_back(v);
  if (common.empty()) return triangles_intersect(a.corners, b.corners) == Crossing::none;
  const Corners x = from(a, place(a, common[0])), y = from(b, place(b, common[0]));
  if (common.size() == 1) return triangles_intersect_sharing_vertex(x[0], x[1], x[2], y[1], y[2]) == Crossing::none;
  if (common.size() == 3) return false;
  auto apex = [&](const PlannedTriangle& t) {
    for (std::size_t i = 0; i < 3; ++i)
      if (t.vertices[i] != common[0] && t.vertices[i] != common[1]) return t.corners[i];
    return t.corners[0];
  };
  return !coplanar_overlap_sharing_edge(x[0], a.corners[place(a, common[1])], apex(a), apex(b));
}

bool is_consistent_around(const ChangePlan& plan, Vertex v, Vertex w, const Vec3& x, const Vec3& y) {
  const Vec3 axis = (y - x).normalized();
  const Vec3 u = axis.unitOrthogonal(), side = axis.cross(u);
  boost::container::small_vector<Turned, 4> films;
  for (const PlannedTriangle& t : plan.triangles) {
    const std::size_t i = place(t, v), j = place(t, w);
    if (i == 3 || j == 3) continue;
    const Vec3 arm = t.corners[3 - i - j] - x;
    const Labels labels = j == (i + 1) % 3 ? t.labels : t.labels.flipped();
    films.push_back({std::atan2(arm.dot(side), arm.dot(u)), labels.p, labels.q});
  }
  if (films.size() < 2) return false;
  std::ranges::sort(films, {}, &Turned::angle);
  for (std::size_t i = 0; i < films.size(); ++i)
    if (films[i].after != films[(i + 1) % films.size()].before) return false;
  return true;
}

}  // namespace

bool planned_triangles_are_apart(const ChangePlan& plan) {
  for (std::size_t i = 0; i < plan.triangles.size(); ++i)
    for (std::size_t j = i + 1; j < plan.triangles.size(); ++j)
      if (!are_apart(plan.triangles[i], plan.triangles[j])) return false;
  return true;
}

bool planned_labels_are_consistent(const ChangePlan& plan, Vertex v) {
  boost::container::small_vector<Vertex, 16> seen;
  for (const PlannedTriangle& t : plan.triangles) {
    const std::size_t at = place(t, v);
    if (at == 3) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vertex w = t.vertices[i];
      if (w == v || std::ranges::find(seen, w) != seen.end()) continue;
      seen.push_back(w);
      if (!is_consistent_around(plan, v, w, t.corners[at], t.corners[i])) return false;
    }
  }
  return true;
}

}  // namespace lostopos
