#include "LosTopos/geometry/hull_pose.h"

#include <Eigen/Geometry>

#include "LosTopos/geometry/distance.h"

namespace lostopos {
namespace {

using Kind = HullFeature::Kind;

// An edge of the hull starts at a corner; both are needed as functions of the hull and of a pose.
constexpr std::array<std::size_t, 3> triangle_edge_corner = {0, 1, 2};
constexpr std::array<std::size_t, 4> parallelogram_edge_corner = {0, 2, 0, 1};

std::size_t edge_corner(int size, int edge) {
  const auto i = static_cast<std::size_t>(edge);
  return size == 3 ? triangle_edge_corner[i] : parallelogram_edge_corner[i];
}

Vec3 edge_vector(int size, int edge, const Vec3& e1, const Vec3& e2) {
  if (size == 4) return edge < 2 ? e2 : e1;
  if (edge == 1) return e2 - e1;
  return edge == 0 ? e1 : e2;
}

}  // namespace

HullPose::HullPose(const MovingHull& hull, double t) : hull_(hull), e1_(hull.e1.at(t)), e2_(hull.e2.at(t)) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(hull.size); ++i) corners_[i] = hull.corners[i].at(t);
}

HullFeature HullPose::nearest_feature() const {
  return hull_.size == 3 ? nearest_of_triangle() : nearest_of_edges();
}

HullFeature HullPose::nearest_of_triangle() const {
  const Vec3 weights = point_triangle_distance(Vec3::Zero(), corners_[0], corners_[1], corners_[2]).weights;
  for (int i = 0; i < 3; ++i) {
    if (weights[i] == 1) return {Kind::corner, i};
  }
  if (weights[2] == 0) return {Kind::edge, 0};
  if (weights[0] == 0) return {Kind::edge, 1};
  if (weights[1] == 0) return {Kind::edge, 2};
  return {Kind::face};
}

HullFeature HullPose::nearest_of_edges() const {
  // With a at the origin: ab is (0, e1), cd is (c - a, d - a).
  const auto nearest = segment_segment_distance(Vec3::Zero(), e1_, corners_[0], corners_[1]);
  const bool s_at_end = nearest.s == 0 || nearest.s == 1;
  const bool t_at_end = nearest.t == 0 || nearest.t == 1;
  if (s_at_end && t_at_end) return {Kind::corner, (nearest.s == 0 ? 0 : 2) + (nearest.t == 0 ? 0 : 1)};
  if (s_at_end) return {Kind::edge, nearest.s == 0 ? 0 : 1};
  if (t_at_end) return {Kind::edge, nearest.t == 0 ? 2 : 3};
  return {Kind::face};
}

Vec3 HullPose::direction(const HullFeature& feature) const {
  switch (feature.kind) {
    case Kind::face: {
      const Vec3 n = e1_.cross(e2_);
      return n.dot(corners_[0]) < 0 ? Vec3(-n) : n;
    }
    case Kind::edge: {
      const Vec3 edge = edge_vector(hull_.size, feature.index, e1_, e2_);
      return edge.cross(corners_[edge_corner(hull_.size, feature.index)]).cross(edge);
    }
    default:
      return corners_[static_cast<std::size_t>(feature.index)];
  }
}

MovingVector HullPose::turning_edge_direction(int edge) const {
  const Vec3 now = edge_vector(hull_.size, edge, e1_, e2_);
  const Vec3 axis = now.cross(corners_[edge_corner(hull_.size, edge)]);
  return {axis.cross(edge_vector(hull_.size, edge, hull_.e1.start, hull_.e2.start)),
          axis.cross(edge_vector(hull_.size, edge, hull_.e1.end, hull_.e2.end))};
}

}  // namespace lostopos
