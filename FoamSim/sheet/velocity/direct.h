#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "Base/parallel/ranks.h"
#include "FoamSim/sheet/velocity/biot_savart.h"

namespace foamsim {

/// Every source at every target: O(sources × targets), the yardstick for fast summations.
///
/// SIMD over targets with run-time choice of the instruction set, oneTBB threads over blocks of targets. Each target's
/// sum runs over the sources in their order, by IEEE additions, multiplications, divisions and square roots alone, no
/// fused ones: same bits for every instruction set, number of threads and division of the targets among calls, and
/// velocities that scale exactly when lengths or strengths are scaled by a power of two.
///
/// Error against exact arithmetic, for up to 10⁵ sources: at most 1e-13 (1/4π) Σ_t |γ_t| |x − m_t| / (|x − m_t|² +
/// δ²)^{3/2}.
class DirectBiotSavart final : public BiotSavart {
 public:
  /// `ranks`: share out the targets.
  explicit DirectBiotSavart(std::shared_ptr<const base::Ranks> ranks = base::alone()) : ranks_(std::move(ranks)) {}
  void velocities(const VortexSources& sources, std::span<const lostopos::Vec3> targets, double delta,
                  std::span<lostopos::Vec3> out) const override;

  /// Name of the instruction set in use on this machine, as Highway calls it ("AVX3" is AVX-512).
  static std::string_view simd_target();

  std::unique_ptr<PairSummation> pair_sums(Precision precision) const override;

 private:
  std::shared_ptr<const base::Ranks> ranks_;
};

}  // namespace foamsim
