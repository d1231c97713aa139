#include "FoamSim/sheet/velocity/direct.h"

#include <algorithm>
#include <cstddef>

#include "Base/parallel/for_each.h"
#include "FoamSim/sheet/velocity/direct_kernel.h"

namespace foamsim {
namespace {

// Targets a task: some full vectors of the widest kind, and small enough to share out a few thousand targets evenly.
constexpr std::size_t kBlock = 32;

}  // namespace

void DirectBiotSavart::velocities(const VortexSources& sources, std::span<const lostopos::Vec3> targets, double delta,
                                  std::span<lostopos::Vec3> out) const {
  check_arguments(sources, targets, delta, out);
  const std::size_t blocks = (targets.size() + kBlock - 1) / kBlock;
  base::parallel_for_each(blocks, 1, [&](std::size_t block) {
    const std::size_t first = block * kBlock;
    const std::size_t count = std::min(kBlock, targets.size() - first);
    sum_biot_savart(sources, targets.subspan(first, count), delta, out.subspan(first, count));
  });
}

std::string_view DirectBiotSavart::simd_target() {
  return biot_savart_simd_target();
}

}  // namespace foamsim
