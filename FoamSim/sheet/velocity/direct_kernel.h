#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "FoamSim/sheet/velocity/vortex_sources.h"
#include "LosTopos/vec3.h"

namespace foamsim {

/// The direct Biot–Savart sum on the calling thread, in the best instruction set of the machine; arguments as for
/// BiotSavart::velocities, but unchecked. A target's velocity depends on its own position and the sources only.
void sum_biot_savart(const VortexSources& sources, std::span<const lostopos::Vec3> targets, double delta,
                     std::span<lostopos::Vec3> out);

/// Names of the instruction sets that this program has code for and this machine runs, best first.
std::vector<std::string> simd_targets();

/// Sums use this instruction set from now on, in the whole process and whatever they sum; set before any begins.
/// Throws base::InputError for one that is not among simd_targets().
void use_simd_target(std::string_view name);

/// Name of the instruction set that sum_biot_savart uses.
const char* biot_savart_simd_target();

}  // namespace foamsim
