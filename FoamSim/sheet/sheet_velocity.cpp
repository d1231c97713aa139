#include "FoamSim/sheet/sheet_velocity.h"

#include <algorithm>

namespace foamsim {

namespace {

// No strength anywhere, as in a scene that only grows bubbles: the sum, by far the largest cost, is known.
bool is_at_rest(const VortexSources& sources) {
  const auto all_zero = [](const VortexSources::Array& values) {
    return std::ranges::all_of(values, [](double value) { return value == 0; });
  };
  return all_zero(sources.gx) && all_zero(sources.gy) && all_zero(sources.gz);
}

}  // namespace

void SheetVelocity::evaluate(std::span<const SheetTriangle> sheet, std::span<const lostopos::Vec3> positions,
                             std::span<const lostopos::Vec3> targets, double delta,
                             std::span<lostopos::Vec3> velocity) {
  fill_vortex_sources(sheet, positions, sources_);
  if (is_at_rest(sources_))
    std::ranges::fill(velocity, lostopos::Vec3::Zero());
  else
    sum_->velocities(sources_, targets, delta, velocity);
  ++evaluations_;
}

}  // namespace foamsim
