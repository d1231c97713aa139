#include "LosTopos/collision/pair_test.h"

#include <algorithm>
#include <cmath>

#include "LosTopos/collision/impulses.h"
#include "LosTopos/geometry/ccd.h"
#include "LosTopos/geometry/distance.h"

namespace lostopos {
namespace {

// Repulsion may open a gap by this share of what it lacks to ε_c in one step (Bridson et al. 2002, section 7.2).
constexpr double repulsion_share = 0.1;
// Of the gap between colliding elements, that they may close in the step: the motion is not a velocity that has to end,
// but a way that is barred. What is pressed together comes close enough to be joined, step by step.
constexpr double approach_share = 0.5;
// Of its distance at the start, that a near pair has to keep.
constexpr double kept_share = 0.5;

struct Nearest {
  double distance;
  std::array<double, 4> weights;  // signed
  Vec3 offset;                    // from the second element to the first
};

Nearest nearest_points(std::span<const Vec3> x, const ElementPair& pair) {
  const auto at = [&](std::size_t i) -> const Vec3& { return x[pair.vertices[i].index()]; };
  if (pair.kind == ElementPair::Kind::vertex_triangle) {
    const PointTriangleDistance d = point_triangle_distance(at(0), at(1), at(2), at(3));
    return {d.distance, {1, -d.weights[0], -d.weights[1], -d.weights[2]}, d.offset};
  }
  const SegmentSegmentDistance d = segment_segment_distance(at(0), at(1), at(2), at(3));
  return {d.distance, {1 - d.s, d.s, d.t - 1, -d.t}, d.offset};
}

// No two points of the elements move farther than this relative to each other: their relative displacement is a mean of
// the vertices'.
double relative_motion(const Motion& motion, const ElementPair& pair) {
  std::array<Vec3, 4> d;
  for (std::size_t i = 0; i < 4; ++i) d[i] = motion.displacement(pair.vertices[i]);
  double largest = std::max((d[0] - d[2]).squaredNorm(), (d[0] - d[3]).squaredNorm());
  if (pair.kind == ElementPair::Kind::vertex_triangle) {
    largest = std::max(largest, (d[0] - d[1]).squaredNorm());
  } else {
    largest = std::max({largest, (d[1] - d[2]).squaredNorm(), (d[1] - d[3]).squaredNorm()});
  }
  return std::sqrt(largest);
}

std::optional<Collision> detect(const Motion& motion, const ElementPair& pair) {
  std::array<Trajectory, 4> x;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t v = pair.vertices[i].index();
    x[i] = {motion.starts()[v], motion.ends()[v]};
  }
  return pair.kind == ElementPair::Kind::vertex_triangle ? vertex_triangle_collision(x[0], x[1], x[2], x[3])
                                                         : edge_edge_collision(x[0], x[1], x[2], x[3]);
}

Contact from_collision(const Motion& motion, const ElementPair& pair, const Collision& collision) {
  Contact contact = {pair, collision.weights, collision.normal, collision.time, 0};
  for (std::size_t i = pair.kind == ElementPair::Kind::vertex_triangle ? 1 : 2; i < 4; ++i) {
    contact.weights[i] = -contact.weights[i];
  }
  Vec3 gap = Vec3::Zero();
  for (std::size_t i = 0; i < 4; ++i) gap += contact.weights[i] * motion.starts()[pair.vertices[i].index()];
  contact.target = -approach_share * std::max(0.0, contact.normal.dot(gap));
  return contact;
}

// A pair that does not collide but ends too near each other.
std::optional<Contact> squeezed(const Motion& motion, const ElementPair& pair, double start_distance,
                                const ContactScale& scale) {
  const double least = std::min(scale.least_gap, kept_share * start_distance);
  const Nearest end = nearest_points(motion.ends(), pair);
  if (!(end.distance < least) || end.distance == 0) return std::nullopt;
  Contact contact = {pair, end.weights, end.offset / end.distance, 1, 0};
  contact.target = relative_displacement(motion, contact) + (least - end.distance);
  return contact;
}

}  // namespace

PairResult test_pair(const Motion& motion, const ElementPair& pair, const ContactScale& scale) {
  PairResult result;
  const Nearest start = nearest_points(motion.starts(), pair);
  if (start.distance - relative_motion(motion, pair) > scale.safe) return result;
  if (start.distance < scale.proximity && start.distance > 0) {
    result.proximity = {pair, start.weights, start.offset / start.distance, 0,
                        repulsion_share * (scale.proximity - start.distance)};
  }
  if (const std::optional<Collision> collision = detect(motion, pair)) {
    result.collision = from_collision(motion, pair, *collision);
  } else {
    result.collision = squeezed(motion, pair, start.distance, scale);
  }
  return result;
}

}  // namespace lostopos
