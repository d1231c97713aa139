#pragma once

#include "Base/parallel/ranks.h"
#include "FoamSim/sheet/velocity/biot_savart.h"
#include "FoamSim/sheet/velocity/tree/tree_sum.h"

namespace foamsim {

/// How good tree sums are.
struct TreeOptions {
  double tolerance = 1e-4;        ///< largest error over largest value, 1e-8 to 1e-2
  std::size_t order = 0;          ///< largest degree of the interpolants, 1 to 15; 0: what the tolerance asks for
  bool direct_where_few = false;  ///< sums over as few triangles as direct sums are the faster for are direct
};

/// Up to how many triangles that is, as benchmarks/tree_sum_benchmark.cpp finds it at tolerances of 1e-4 and 1e-6: for
/// velocities at half as many targets, and for the sums of sources on themselves, which direct ones visit by pairs
/// and in single precision.
std::size_t few_for_velocities(const TreeOptions& options);
std::size_t few_for_pairs(const TreeOptions& options);

/// Sums by clusters (tree_sum.h): O(n).
class TreeBiotSavart final : public BiotSavart {
 public:
  explicit TreeBiotSavart(const TreeOptions& options, std::shared_ptr<const base::Ranks> ranks = base::alone())
      : options_(options), ranks_(std::move(ranks)) {}
  void velocities(const VortexSources& sources, std::span<const lostopos::Vec3> targets, double delta,
                  std::span<lostopos::Vec3> out) const override;
  std::unique_ptr<PairSummation> pair_sums(Precision precision) const override;

 private:
  TreeOptions options_;
  std::shared_ptr<const base::Ranks> ranks_;
};

/// The same of sources on themselves, or directly where there are few.
class TreePairSums final : public PairSummation {
 public:
  TreePairSums(const TreeOptions& options, Precision precision,
               const std::shared_ptr<const base::Ranks>& ranks = base::alone())
      : options_(options), ranks_(ranks), direct_(precision, ranks) {}
  void evaluate(const VortexSources& sources, double delta, PairTerms terms, PairSums& sums) override;

 private:
  TreeOptions options_;
  std::shared_ptr<const base::Ranks> ranks_;
  DirectPairSums direct_;
  TreeSum tree_;
};

}  // namespace foamsim
