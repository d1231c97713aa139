#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "Base/parallel/ranks.h"
#include "FoamSim/sheet/velocity/pair_sums.h"
#include "FoamSim/sheet/velocity/tree/tree_accuracy.h"
#include "FoamSim/sheet/velocity/tree/tree_kernel.h"
#include "FoamSim/sheet/velocity/vortex_sources.h"
#include "LosTopos/vec3.h"

namespace foamsim {

/// All of a tree sum that does not depend on strengths: clusters, which of them meet, and memory for the sums.
class TreePlan {
 public:
  TreePlan(const TreePlan&) = delete;
  TreePlan& operator=(const TreePlan&) = delete;
  virtual ~TreePlan() = default;

  /// For sources and targets as TreeSum::evaluate has them, one or more of each, in the precision of `accuracy`.
  static std::unique_ptr<TreePlan> make(const VortexSources& sources, const std::span<const lostopos::Vec3>* targets,
                                        double delta, const TreeAccuracy& accuracy);

  /// Whether it was made for these, to the bit.
  bool fits(const VortexSources& sources, const std::span<const lostopos::Vec3>* targets, double delta,
            const TreeAccuracy& accuracy) const;

  /// The sums with these strengths; the sources' places have to be those that it was made for. `ranks`: share out the
  /// clusters of targets.
  virtual void sum(const VortexSources& sources, TreeTerms terms, const base::Ranks& ranks, PairSums& result) = 0;

 protected:
  TreePlan(const VortexSources& sources, const std::span<const lostopos::Vec3>* targets, double delta,
           const TreeAccuracy& accuracy);

  std::vector<lostopos::Vec3> points_;                  ///< of the sources
  std::optional<std::vector<lostopos::Vec3>> targets_;  ///< none: the sources
  double delta_;
  TreeAccuracy accuracy_;
};

}  // namespace foamsim
