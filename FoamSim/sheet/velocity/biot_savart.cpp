#include "FoamSim/sheet/velocity/biot_savart.h"

#include <cmath>
#include <string>

#include "Base/error.h"

namespace foamsim {

std::unique_ptr<PairSummation> BiotSavart::pair_sums(Precision precision) const {
  return std::make_unique<DirectPairSums>(precision);
}

void BiotSavart::check_arguments(const VortexSources& sources, std::span<const lostopos::Vec3> targets, double delta,
                                 std::span<const lostopos::Vec3> out) {
  if (!std::isfinite(delta) || delta < 0) {
    throw base::InputError("Biot-Savart: regularisation delta = " + std::to_string(delta) +
                           "; it must be a finite length >= 0");
  }
  if (out.size() != targets.size()) {
    throw base::InputError("Biot-Savart: " + std::to_string(targets.size()) + " targets, but room for " +
                           std::to_string(out.size()) + " velocities; there must be one a target");
  }
  const std::size_t n = sources.size();
  for (const auto* array : {&sources.y, &sources.z, &sources.gx, &sources.gy, &sources.gz}) {
    if (array->size() != n) {
      throw base::InputError("Biot-Savart: the arrays of the sources have " + std::to_string(n) + " and " +
                             std::to_string(array->size()) + " entries; all must have the same length");
    }
  }
}

}  // namespace foamsim
