#pragma once

#include <memory>
#include <span>
#include <vector>

#include "Base/parallel/ranks.h"
#include "FoamSim/sheet/velocity/pair_sums.h"
#include "FoamSim/sheet/velocity/tree/tree_accuracy.h"
#include "FoamSim/sheet/velocity/tree/tree_kernel.h"
#include "FoamSim/sheet/velocity/vortex_sources.h"
#include "LosTopos/vec3.h"

namespace foamsim {

class TreePlan;

/// Sums of regularised vortices by clusters of sources on clusters of targets: O(n).
///
/// Far clusters meet by their values at Chebyshev points (barycentric Lagrange dual tree traversal: Wang, Krasny and
/// Tlupova 2020; Wilson, Vaughn and Krasny 2021), near points one by one. Derivatives are those of the interpolants.
/// Without targets of their own sources are the targets, and the operator from γ to Ψ is symmetric. Same bits for any
/// number of threads, and whether or not the clusters are those of the sum before, which stay for as long as points,
/// δ and accuracy do.
class TreeSum {
 public:
  TreeSum();
  ~TreeSum();

  /// @param sources points m_t (L) and strengths γ (L³/T).
  /// @param targets points x (L); null: the sources, with themselves (their own potential γ/(4πδ) is in Ψ).
  /// @param delta   δ >= 0 (L).
  /// @param ranks   share out the clusters of targets.
  /// @param result  what `terms` names, one of each a target, in the units of PairSums; the rest is empty. B is 0 for
  ///                targets that are not the sources, which have no strength.
  /// @throws base::InputError when delta is negative or not finite.
  void evaluate(const VortexSources& sources, const std::span<const lostopos::Vec3>* targets, double delta,
                TreeTerms terms, const TreeAccuracy& accuracy, const base::Ranks& ranks, PairSums& result);
  /// The same of one process alone.
  void evaluate(const VortexSources& sources, const std::span<const lostopos::Vec3>* targets, double delta,
                TreeTerms terms, const TreeAccuracy& accuracy, PairSums& result) {
    evaluate(sources, targets, delta, terms, accuracy, *base::alone(), result);
  }

 private:
  std::unique_ptr<TreePlan> plan_;
};

}  // namespace foamsim
