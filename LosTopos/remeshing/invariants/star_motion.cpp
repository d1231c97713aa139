#include "LosTopos/remeshing/invariants/star_motion.h"

#include <algorithm>

namespace lostopos {
namespace {

Box swept_box(std::span<const MovingPoint> points) {
  Box box{points[0].path.start, points[0].path.start};
  for (const MovingPoint& p : points) {
    box.low = box.low.cwiseMin(p.path.start).cwiseMin(p.path.end);
    box.high = box.high.cwiseMax(p.path.start).cwiseMax(p.path.end);
  }
  return box;
}

}  // namespace

void StarMotion::clear() {
  points_.clear();
  edges_.clear();
  triangles_.clear();
}

void StarMotion::add_planned_star(const ChangePlan& plan, Vertex vertex, const Vec3& target) {
  for (const PlannedTriangle& planned : plan.triangles) {
    Points points;
    bool moves = false;
    for (std::size_t i = 0; i < 3; ++i) {
      const bool here = planned.vertices[i] == vertex;
      points[i] = {planned.vertices[i], {planned.corners[i], here ? target : planned.corners[i]}, here};
      moves |= here;
    }
    if (moves) add(points);
  }
}

void StarMotion::add(const Points& corners) {
  const Box box = swept_box(corners);
  box_ = triangles_.empty() ? box : Box{box_.low.cwiseMin(box.low), box_.high.cwiseMax(box.high)};
  triangles_.push_back({corners, box});
  for (std::size_t i = 0; i < 3; ++i) {
    add_point(corners[i]);
    add_edge(corners[i], corners[(i + 1) % 3]);
  }
}

void StarMotion::add_point(const MovingPoint& point) {
  if (point.moves && std::ranges::find(points_, point.vertex, &MovingPoint::vertex) == points_.end())
    points_.push_back(point);
}

void StarMotion::add_edge(const MovingPoint& a, const MovingPoint& b) {
  if (!a.moves && !b.moves) return;
  const auto& [first, second] = std::minmax(a, b, [](const auto& x, const auto& y) { return x.vertex < y.vertex; });
  const bool known = std::ranges::any_of(edges_, [&f = first, &s = second](const MovingEdge& e) {
    return e.ends[0].vertex == f.vertex && e.ends[1].vertex == s.vertex;
  });
  if (known) return;
  const std::array<MovingPoint, 2> ends = {first, second};
  edges_.push_back({ends, swept_box(ends)});
}

}  // namespace lostopos
