#pragma once

#include <span>

#include "FoamSim/sheet/velocity/vortex_sources.h"
#include "LosTopos/vec3.h"

namespace foamsim {

/// The direct Biot–Savart sum on the calling thread, in the best instruction set of the machine; arguments as for
/// BiotSavart::velocities, but unchecked. A target's velocity depends on its own position and the sources only.
void sum_biot_savart(const VortexSources& sources, std::span<const lostopos::Vec3> targets, double delta,
                     std::span<lostopos::Vec3> out);

/// Name of the instruction set that sum_biot_savart uses.
const char* biot_savart_simd_target();

}  // namespace foamsim
