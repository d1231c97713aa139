#include "LosTopos/remeshing/invariants/shape.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "LosTopos/geometry/predicates.h"

namespace lostopos {

bool keeps_min_angle(const ChangePlan& plan, const Limits& limits) {
  return plan.after.min_angle >= limits.min_angle || plan.after.min_angle >= plan.before.min_angle;
}

bool keeps_max_angle(const ChangePlan& plan, const Limits& limits) {
  return plan.after.max_angle <= limits.max_angle || plan.after.max_angle <= plan.before.max_angle;
}

bool keeps_min_area(const ChangePlan& plan, const Limits& limits) {
  return plan.after.min_area >= limits.min_area || plan.after.min_area >= plan.before.min_area;
}

bool keeps_longest_edge(const ChangePlan& plan, const Limits& limits) {
  return plan.after.longest_edge <= limits.longest_edge || plan.after.longest_edge <= plan.before.longest_edge;
}

bool keeps_orientation(const ChangePlan& plan, const Limits&) {
  return std::ranges::all_of(plan.triangles, [](const PlannedTriangle& t) {
    const auto& [a, b, c] = t.corners;
    if (collinear(a, b, c)) return false;
    return t.old_normal.isZero(0) || (b - a).cross(c - a).dot(t.old_normal) > 0;
  });
}

bool improves_min_angle(const ChangePlan& plan, const Limits&) {
  return plan.after.min_angle > plan.before.min_angle * (1 + 1e-6);
}

}  // namespace lostopos
