#include "FoamSim/metrics/rest_detector.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace foamsim {

double characteristic_time(const std::vector<lostopos::RegionVolume>& volumes, double sigma) {
  double sum = 0;
  int bubbles = 0;
  for (const auto& [region, volume] : volumes)
    if (region != lostopos::air) {
      sum += std::abs(volume);
      ++bubbles;
    }
  if (bubbles == 0 || sigma <= 0) return 0;
  const double radius_cubed = 3 * sum / (bubbles * 4 * std::numbers::pi);
  return std::sqrt(radius_cubed / sigma);
}

bool RestDetector::add(const Metrics& metrics) {
  if (!(window_ > 0)) return false;  // nothing by which to tell rest
  if (!(metrics.kinetic_energy < energy_ratio * metrics.potential_energy)) {
    quiet_.clear();
    return false;
  }
  quiet_.push_back({metrics.time, metrics.angle_rms_deg.value_or(0)});
  if (metrics.time - quiet_.front().time < window_) return false;
  const auto [low, high] = std::ranges::minmax(quiet_, {}, &Sample::angle);
  while (metrics.time - quiet_.front().time >= window_) quiet_.pop_front();
  return high.angle - low.angle < angle_change_deg;
}

}  // namespace foamsim
