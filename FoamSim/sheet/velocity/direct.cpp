#include "FoamSim/sheet/velocity/direct.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>

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
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, blocks), [&](const tbb::blocked_range<std::size_t>& range) {
    const std::size_t first = range.begin() * kBlock;
    const std::size_t count = std::min(range.end() * kBlock, targets.size()) - first;
    sum_biot_savart(sources, targets.subspan(first, count), delta, out.subspan(first, count));
  });
}

std::string_view DirectBiotSavart::simd_target() {
  return biot_savart_simd_target();
}

}  // namespace foamsim
