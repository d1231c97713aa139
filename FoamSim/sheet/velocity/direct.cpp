#include "FoamSim/sheet/velocity/direct.h"

#include <algorithm>
#include <cstddef>

#include "Base/parallel/for_each.h"
#include "FoamSim/sheet/velocity/direct_kernel.h"

namespace foamsim {
namespace {

// Targets a task: some full vectors of the widest kind, and small enough to share out a few thousand targets evenly.
constexpr std::size_t kBlock = 32;

std::span<double> components_of(std::span<lostopos::Vec3> vectors) {
  static_assert(sizeof(lostopos::Vec3) == 3 * sizeof(double));
  return {vectors.empty() ? nullptr : vectors.front().data(), 3 * vectors.size()};
}

}  // namespace

void DirectBiotSavart::velocities(const VortexSources& sources, std::span<const lostopos::Vec3> targets, double delta,
                                  std::span<lostopos::Vec3> out) const {
  check_arguments(sources, targets, delta, out);
  if (ranks_->size() > 1) std::ranges::fill(out, lostopos::Vec3::Zero());
  const auto [begin, end] = ranks_->share((targets.size() + kBlock - 1) / kBlock);
  base::parallel_for_each(end - begin, 1, [&, begin = begin](std::size_t i) {
    const std::size_t first = (begin + i) * kBlock;
    const std::size_t count = std::min(kBlock, targets.size() - first);
    sum_biot_savart(sources, targets.subspan(first, count), delta, out.subspan(first, count));
  });
  ranks_->gather(components_of(out));
}

std::unique_ptr<PairSummation> DirectBiotSavart::pair_sums(Precision precision) const {
  return std::make_unique<DirectPairSums>(precision, ranks_);
}

std::string_view DirectBiotSavart::simd_target() {
  return biot_savart_simd_target();
}

}  // namespace foamsim
