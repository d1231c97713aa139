#include "FoamSim/sheet/velocity/tree/tree.h"

#include <algorithm>
#include <cmath>

#include "Base/error.h"
#include "FoamSim/sheet/velocity/direct.h"

namespace foamsim {

using lostopos::Vec3;

namespace {

TreeAccuracy accuracy_of(const TreeOptions& options, std::size_t n) {
  TreeAccuracy accuracy = TreeAccuracy::of(options.tolerance, n);
  if (options.order > 0) accuracy.nodes = options.order + 1;
  return accuracy;
}

}  // namespace

void TreeBiotSavart::velocities(const VortexSources& sources, std::span<const Vec3> targets, double delta,
                                std::span<Vec3> out) const {
  if (sources.size() <= options_.direct_up_to) {
    DirectBiotSavart().velocities(sources, targets, delta, out);
    return;
  }
  check_arguments(sources, targets, delta, out);
  PairSums sums;
  TreeSum().evaluate(sources, &targets, delta, TreeTerms::velocity, accuracy_of(options_, sources.size()), sums);
  std::ranges::copy(sums.velocity, out.begin());
}

std::unique_ptr<PairSummation> TreeBiotSavart::pair_sums(Precision precision) const {
  return std::make_unique<TreePairSums>(options_, precision);
}

void TreePairSums::evaluate(const VortexSources& sources, double delta, PairTerms terms, PairSums& sums) {
  if (sources.size() <= options_.direct_up_to) {
    direct_.evaluate(sources, delta, terms, sums);
    return;
  }
  if (!std::isfinite(delta) || !(delta > 0)) throw base::InputError("delta has to be a finite length > 0");
  tree_.evaluate(sources, nullptr, delta, terms == PairTerms::all ? TreeTerms::all : TreeTerms::potential,
                 accuracy_of(options_, sources.size()), sums);
}

}  // namespace foamsim
