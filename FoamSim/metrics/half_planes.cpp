#include "FoamSim/metrics/half_planes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace foamsim {

void DihedralAngles::add(std::array<HalfPlane, 3> planes) {
  ++places_;
  std::ranges::sort(planes, {}, &HalfPlane::angle);
  for (std::size_t i = 0; i < 3; ++i) {
    double angle = planes[(i + 1) % 3].angle - planes[i].angle;
    if (i == 2) angle += 2 * std::numbers::pi;
    const double degrees = angle * 180 / std::numbers::pi;
    squares_ += (degrees - 120) * (degrees - 120);
    if (planes[i].region_after == lostopos::air) {
      outer_sum_ += degrees;
      ++outer_;
    }
  }
}

std::optional<double> DihedralAngles::rms_deviation_deg() const {
  if (places_ == 0) return {};
  return std::sqrt(squares_ / (3.0 * static_cast<double>(places_)));
}

std::optional<double> DihedralAngles::outer_mean_deg() const {
  if (outer_ == 0) return {};
  return outer_sum_ / static_cast<double>(outer_);
}

}  // namespace foamsim
