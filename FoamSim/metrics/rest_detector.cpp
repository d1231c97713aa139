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

bool RestDetector::add(double time, const StepReport& report,
                       const std::function<std::optional<double>()>& rms_angle_deg) {
  if (!(window_ > 0)) return false;  // nothing by which to tell rest
  if (!(report.kinetic_energy < energy_ratio * report.potential_energy)) {
    quiet_.clear();
    return false;
  }
  quiet_.push_back({time, rms_angle_deg().value_or(0)});
  if (time - quiet_.front().time < window_) return false;
  const auto [low, high] = std::ranges::minmax(quiet_, {}, &Sample::angle);
  while (time - quiet_.front().time >= window_) quiet_.pop_front();
  return high.angle - low.angle < angle_change_deg;
}

}  // namespace foamsim
