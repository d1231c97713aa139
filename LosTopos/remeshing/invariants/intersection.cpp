#include "LosTopos/remeshing/invariants/intersection.h"

#include <algorithm>

#include "Base/lists/erase_repeated.h"
#include "LosTopos/geometry/distance.h"
#include "LosTopos/geometry/predicates.h"
#include "LosTopos/mesh/measures.h"

namespace lostopos {
namespace {

Trajectory at_rest(const Vec3& x) {
  return {x, x};
}

template <class Range>
bool contains(const Range& range, Vertex v) {
  return std::ranges::find(range, v) != std::ranges::end(range);
}

bool shares_a_vertex(std::span<const Vertex> a, std::span<const Vertex> b) {
  return std::ranges::any_of(a, [&](Vertex v) { return contains(b, v); });
}

// Gaps smaller than this share of the region an operation works on are not made: the collision-safe move could not tell
// them from contact.
constexpr double least_gap_share = 1e-6;

double least_gap(const Box& box) {
  return least_gap_share * (box.high - box.low).norm();
}

Box grown(Box box, double margin) {
  box.low.array() -= margin;
  box.high.array() += margin;
  return box;
}

// A gap that was there before may stay, or mending would be blocked; it must not get smaller.
bool narrows(double before, double after, double least) {
  return after < least && after < before;
}

bool holds(const Box& box, const Vec3& x) {
  return (box.low.array() <= x.array()).all() && (x.array() <= box.high.array()).all();
}

}  // namespace

void IntersectionGuard::gather(const Box& box, const LeftOut& left_out) {
  index_.nearby(box, found_);
  // All triangles of an element in the box have been found: the first of them brings it in.
  sift(box, left_out, [](Triangle t, Triangle first) { return t == first; });
}

// Lists the elements in the box of the triangles that were found. `brings(t, first)`: whether t brings in an element
// whose first triangle is `first`.
template <class Brings>
void IntersectionGuard::sift(const Box& box, const LeftOut& left_out, const Brings& brings) {
  vertices_.clear();
  edges_.clear();
  triangles_.clear();
  for (Triangle t : found_) {
    const auto& of_triangle = mesh_.vertices(t);
    const bool gone = std::ranges::find(left_out.triangles, t) != left_out.triangles.end() ||
                      std::ranges::any_of(mesh_.edges(t), [&](Edge e) { return left_out.has(e); });
    if (!gone && !shares_a_vertex(left_out.vertices, of_triangle))
      triangles_.push_back({t, triangle_box(mesh_, t, mesh_.positions(), 0)});
    for (Vertex v : of_triangle)
      if (holds(box, mesh_.position(v)) && brings(t, mesh_.triangles(v)[0]) && !contains(left_out.vertices, v))
        vertices_.push_back({v, at_rest(mesh_.position(v))});
    for (Edge e : mesh_.edges(t)) {
      const auto& ends = mesh_.vertices(e);
      const Vec3 &a = mesh_.position(ends[0]), &b = mesh_.position(ends[1]);
      const Box edge_box{a.cwiseMin(b), a.cwiseMax(b)};
      if (!edge_box.overlaps(box) || !brings(t, mesh_.triangles(e)[0])) continue;
      if (left_out.has(e) || shares_a_vertex(left_out.vertices, ends)) continue;
      edges_.push_back({e, ends, edge_box});
    }
  }
}

bool IntersectionGuard::is_free(const StarMotion& motion, const LeftOut& left_out) {
  least_gap_ = least_gap(motion.box());
  gather(grown(motion.box(), least_gap_), left_out);
  return nothing_is_met(motion);
}

bool IntersectionGuard::move_is_free(Vertex v, const StarMotion& motion) {
  const std::array<Vertex, 1> moving = {v};
  least_gap_ = least_gap(motion.box());
  if (!index_.near_moving(v, motion.points()[0].path.end, least_gap_, found_)) return is_free(motion, {moving, Edge()});
  if (found_.empty()) return true;
  base::sort_unique(found_);
  sift(grown(motion.box(), least_gap_), {moving, Edge()}, [](Triangle, Triangle) { return true; });
  return nothing_is_met(motion);
}

bool IntersectionGuard::nothing_is_met(const StarMotion& motion) const {
  return std::ranges::all_of(motion.triangles(), [this](const auto& t) { return triangle_is_free(t); }) &&
         std::ranges::all_of(motion.edges(), [this](const auto& e) { return edge_is_free(e); }) &&
         std::ranges::all_of(motion.points(), [this](const auto& p) { return point_is_free(p); });
}

bool IntersectionGuard::point_is_free(const MovingPoint& point) const {
  const Box box =
      grown({point.path.start.cwiseMin(point.path.end), point.path.start.cwiseMax(point.path.end)}, least_gap_);
  return std::ranges::none_of(triangles_, [&](const StaticTriangle& t) {
    if (!box.overlaps(t.box)) return false;
    const auto [a, b, c] = corners(mesh_, t.triangle);
    return vertex_triangle_collision(point.path, at_rest(a), at_rest(b), at_rest(c)).has_value() ||
           narrows(point_triangle_distance(point.path.start, a, b, c).distance,
                   point_triangle_distance(point.path.end, a, b, c).distance, least_gap_);
  });
}

bool IntersectionGuard::edge_is_free(const StarMotion::MovingEdge& edge) const {
  const std::array<Vertex, 2> names = {edge.ends[0].vertex, edge.ends[1].vertex};
  const Trajectory &p = edge.ends[0].path, &q = edge.ends[1].path;
  const Box box = grown(edge.box, least_gap_);
  return std::ranges::none_of(edges_, [&](const StaticEdge& e) {
    if (!box.overlaps(e.box) || shares_a_vertex(names, e.ends)) return false;
    const Vec3 &a = mesh_.position(e.ends[0]), &b = mesh_.position(e.ends[1]);
    return edge_edge_collision(p, q, at_rest(a), at_rest(b)).has_value() ||
           narrows(segment_segment_distance(p.start, q.start, a, b).distance,
                   segment_segment_distance(p.end, q.end, a, b).distance, least_gap_);
  });
}

bool IntersectionGuard::triangle_is_free(const StarMotion::MovingTriangle& triangle) const {
  const auto& [a, b, c] = triangle.corners;
  const Box box = grown(triangle.box, least_gap_);
  return std::ranges::none_of(vertices_, [&a = a, &b = b, &c = c, &box, this](const StaticVertex& v) {
    if (v.vertex == a.vertex || v.vertex == b.vertex || v.vertex == c.vertex) return false;
    const Vec3& x = v.path.start;
    return holds(box, x) &&
           (vertex_triangle_collision(v.path, a.path, b.path, c.path).has_value() ||
            narrows(point_triangle_distance(x, a.path.start, b.path.start, c.path.start).distance,
                    point_triangle_distance(x, a.path.end, b.path.end, c.path.end).distance, least_gap_));
  });
}

bool IntersectionGuard::flip_is_free(Edge e, Vertex c, Vertex d) {
  const auto [a, b] = mesh_.vertices(e);
  Box box{mesh_.position(a), mesh_.position(a)};
  for (Vertex v : {b, c, d}) {
    box.low = box.low.cwiseMin(mesh_.position(v));
    box.high = box.high.cwiseMax(mesh_.position(v));
  }
  least_gap_ = least_gap(box);
  gather(grown(box, least_gap_), {{}, e});
  const std::array<Vertex, 3> at_a = {a, d, c}, at_b = {b, c, d};
  if (!new_edge_is_free(c, d) || !new_triangle_is_free(at_a) || !new_triangle_is_free(at_b)) return false;
  if (!tetrahedron_is_empty({a, b, c, d})) return false;
  for (Vertex v : {c, d})
    if (!is_not_folded(mesh_.find_edge(a, v), at_a) || !is_not_folded(mesh_.find_edge(b, v), at_b)) return false;
  return !coplanar_overlap_sharing_edge(mesh_.position(c), mesh_.position(d), mesh_.position(a), mesh_.position(b));
}

bool IntersectionGuard::new_edge_is_free(Vertex c, Vertex d) const {
  return std::ranges::none_of(triangles_,
                              [&](const StaticTriangle& t) {
                                const auto& names = mesh_.vertices(t.triangle);
                                if (contains(names, c) || contains(names, d)) return false;
                                const auto [x, y, z] = corners(mesh_, t.triangle);
                                return segment_triangle_intersect(mesh_.position(c), mesh_.position(d), x, y, z) !=
                                       Crossing::none;
                              }) &&
         std::ranges::none_of(edges_, [&](const StaticEdge& e) {
           if (contains(e.ends, c) || contains(e.ends, d)) return false;
           return segment_segment_distance(mesh_.position(c), mesh_.position(d), mesh_.position(e.ends[0]),
                                           mesh_.position(e.ends[1]))
                      .distance < least_gap_;
         });
}

bool IntersectionGuard::new_triangle_is_free(const std::array<Vertex, 3>& triangle) const {
  return std::ranges::none_of(edges_,
                              [&](const StaticEdge& e) {
                                if (shares_a_vertex(triangle, e.ends)) return false;
                                return segment_triangle_intersect(mesh_.position(e.ends[0]), mesh_.position(e.ends[1]),
                                                                  mesh_.position(triangle[0]),
                                                                  mesh_.position(triangle[1]),
                                                                  mesh_.position(triangle[2])) != Crossing::none;
                              }) &&
         std::ranges::none_of(vertices_, [&](const StaticVertex& v) {
           if (contains(triangle, v.vertex)) return false;
           return point_triangle_distance(v.path.start, mesh_.position(triangle[0]), mesh_.position(triangle[1]),
                                          mesh_.position(triangle[2]))
                      .distance < least_gap_;
         });
}

bool IntersectionGuard::tetrahedron_is_empty(const std::array<Vertex, 4>& corners) const {
  std::array<Vec3, 4> x;
  for (std::size_t i = 0; i < 4; ++i) x[i] = mesh_.position(corners[i]);
  const int side = orient3d(x[0], x[1], x[2], x[3]);
  if (side == 0) return true;  // then the two new triangles are all of it
  return std::ranges::none_of(vertices_, [&](const StaticVertex& v) {
    if (contains(corners, v.vertex)) return false;
    const Vec3& p = v.path.start;
    return orient3d(p, x[1], x[2], x[3]) * side >= 0 && orient3d(x[0], p, x[2], x[3]) * side >= 0 &&
           orient3d(x[0], x[1], p, x[3]) * side >= 0 && orient3d(x[0], x[1], x[2], p) * side >= 0;
  });
}

// Edge e stays; `triangle` is new there, in place of one of the two that go.
bool IntersectionGuard::is_not_folded(Edge e, const std::array<Vertex, 3>& triangle) const {
  const auto& ends = mesh_.vertices(e);
  const Vertex apex = *std::ranges::find_if(triangle, [&](Vertex v) { return v != ends[0] && v != ends[1]; });
  return std::ranges::none_of(mesh_.triangles(e), [&](Triangle t) {
    const bool stays = std::ranges::any_of(triangles_, [&](const StaticTriangle& s) { return s.triangle == t; });
    return stays && coplanar_overlap_sharing_edge(mesh_.position(ends[0]), mesh_.position(ends[1]),
                                                  mesh_.position(apex), mesh_.position(mesh_.opposite_vertex(t, e)));
  });
}

}  // namespace lostopos
