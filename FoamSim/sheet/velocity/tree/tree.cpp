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

// Trees and direct sums take as long where their points fill this many leaves; a point in double precision counts for
// two.
std::size_t size_of_leaves(const TreeOptions& options, std::size_t leaves) {
  const TreeAccuracy accuracy = accuracy_of(options, 1);
  const std::size_t leaf = accuracy.nodes * accuracy.nodes * accuracy.nodes;
  return leaves * leaf * (accuracy.single_near ? 1 : 2);
}

}  // namespace

std::size_t few_for_velocities(const TreeOptions& options) {
  return size_of_leaves(options, 3);
}

std::size_t few_for_pairs(const TreeOptions& options) {
  return size_of_leaves(options, 48);
}

void TreeBiotSavart::velocities(const VortexSources& sources, std::span<const Vec3> targets, double delta,
                                std::span<Vec3> out) const {
  if (options_.direct_where_few && sources.size() <= few_for_velocities(options_)) {
    DirectBiotSavart(ranks_).velocities(sources, targets, delta, out);
    return;
  }
  check_arguments(sources, targets, delta, out);
  PairSums sums;
  TreeSum().evaluate(sources, &targets, delta, TreeTerms::velocity, accuracy_of(options_, sources.size()), *ranks_,
                     sums);
  std::ranges::copy(sums.velocity, out.begin());
}

std::unique_ptr<PairSummation> TreeBiotSavart::pair_sums(Precision precision) const {
  return std::make_unique<TreePairSums>(options_, precision, ranks_);
}

void TreePairSums::evaluate(const VortexSources& sources, double delta, PairTerms terms, PairSums& sums) {
  if (options_.direct_where_few && sources.size() <= few_for_pairs(options_)) {
    direct_.evaluate(sources, delta, terms, sums);
    return;
  }
  if (!std::isfinite(delta) || !(delta > 0)) throw base::InputError("delta has to be a finite length > 0");
  tree_.evaluate(sources, nullptr, delta, terms == PairTerms::all ? TreeTerms::all : TreeTerms::potential,
                 accuracy_of(options_, sources.size()), *ranks_, sums);
}

}  // namespace foamsim
