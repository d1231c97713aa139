#pragma once

#include "FoamSim/sheet/velocity/biot_savart.h"
#include "FoamSim/sheet/velocity/tree/tree_sum.h"

namespace foamsim {

/// How good tree sums are.
struct TreeOptions {
  double tolerance = 1e-4;  ///< largest error over largest value, 1e-8 to 1e-2
  std::size_t order = 0;    ///< degree of the interpolants, 1 to 15; 0: what the tolerance asks for
  /// Triangles up to which sums are direct; 0: always by tree.
  std::size_t direct_up_to = 0;
};

/// Sums by clusters (tree_sum.h): O(n).
class TreeBiotSavart final : public BiotSavart {
 public:
  explicit TreeBiotSavart(const TreeOptions& options) : options_(options) {}
  void velocities(const VortexSources& sources, std::span<const lostopos::Vec3> targets, double delta,
                  std::span<lostopos::Vec3> out) const override;
  std::unique_ptr<PairSummation> pair_sums(Precision precision) const override;

 private:
  TreeOptions options_;
};

/// The same of sources on themselves, or directly where there are few.
class TreePairSums final : public PairSummation {
 public:
  TreePairSums(const TreeOptions& options, Precision precision) : options_(options), direct_(precision) {}
  void evaluate(const VortexSources& sources, double delta, PairTerms terms, PairSums& sums) override;

 private:
  TreeOptions options_;
  DirectPairSums direct_;
  TreeSum tree_;
};

}  // namespace foamsim
