#include "FoamSim/sheet/sheet_velocity.h"

namespace foamsim {

void SheetVelocity::evaluate(std::span<const SheetTriangle> sheet, std::span<const lostopos::Vec3> positions,
                             std::span<const lostopos::Vec3> targets, double delta,
                             std::span<lostopos::Vec3> velocity) {
  fill_vortex_sources(sheet, positions, sources_);
  sum_->velocities(sources_, targets, delta, velocity);
  ++evaluations_;
}

}  // namespace foamsim
