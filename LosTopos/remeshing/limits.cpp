#include "LosTopos/remeshing/limits.h"

#include <cmath>
#include <numbers>
#include <string>

#include "Base/error.h"

namespace lostopos {
namespace {

void require(bool good, const char* what, double value, const char* expected) {
  if (!good)
    throw base::InputError(std::string("remesh options: ") + what + " is " + std::to_string(value) + "; it has to be " +
                           expected);
}

bool within(double value, double low, double high) {
  return value > low && value < high;  // false for NaN
}

}  // namespace

Limits limits_of(const RemeshOptions& o) {
  require(o.target_edge > 0 && std::isfinite(o.target_edge), "target_edge", o.target_edge, "positive and finite");
  require(within(o.longest_edge, 0, 1e6), "longest_edge", o.longest_edge, "positive");
  // The two halves of the shortest edge that is split must not be collapsed again.
  require(within(o.shortest_edge, 0, 0.5 * o.longest_edge), "shortest_edge", o.shortest_edge,
          "positive and less than half of longest_edge");
  require(o.min_area >= 0, "min_area", o.min_area, "at least 0");
  require(within(o.min_angle, 0, 60), "min_angle", o.min_angle, "between 0 and 60 degrees");
  require(within(o.max_angle, 60, 180), "max_angle", o.max_angle, "between 60 and 180 degrees");
  require(within(o.split_angle, 90, 180), "split_angle", o.split_angle, "between 90 and 180 degrees");
  require(o.max_volume_change >= 0, "max_volume_change", o.max_volume_change, "at least 0");
  require(within(o.smoothing_tolerance, 0, 1), "smoothing_tolerance", o.smoothing_tolerance, "between 0 and 1");
  require(o.max_sweeps >= 1, "max_sweeps", o.max_sweeps, "at least 1");
  const double h = o.target_edge, degree = std::numbers::pi / 180;
  return {.shortest_edge = o.shortest_edge * h,
          .longest_edge = o.longest_edge * h,
          .min_area = o.min_area * h * h,
          .min_angle = o.min_angle * degree,
          .max_angle = o.max_angle * degree,
          .max_volume_change = o.max_volume_change * h * h * h,
          .split_angle = o.split_angle * degree};
}

Limits relaxed(const Limits& limits) {
  Limits wider = limits;
  wider.max_volume_change *= 10;
  wider.longest_edge *= 1.5;
  wider.min_area = 0;
  return wider;
}

}  // namespace lostopos
