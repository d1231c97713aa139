#include "FoamSim/sheet/velocity/tree/tree_sum.h"

#include <cmath>

#include "Base/error.h"
#include "FoamSim/sheet/velocity/tree/tree_plan.h"

namespace foamsim {

using lostopos::Vec3;

TreeSum::TreeSum() = default;
TreeSum::~TreeSum() = default;

void TreeSum::evaluate(const VortexSources& sources, const std::span<const Vec3>* targets, double delta,
                       TreeTerms terms, const TreeAccuracy& accuracy, const base::Ranks& ranks, PairSums& result) {
  if (!std::isfinite(delta) || delta < 0) throw base::InputError("delta has to be a finite length >= 0");
  result = {};
  const std::size_t n = targets != nullptr ? targets->size() : sources.size();
  if (n == 0 || sources.size() == 0) {
    const std::vector<Vec3> nothing(n, Vec3::Zero());
    if (terms != TreeTerms::velocity) result.potential = nothing;
    if (terms != TreeTerms::potential) result.velocity = nothing;
    if (terms == TreeTerms::all) result.force = nothing;
    return;
  }
  if (plan_ == nullptr || !plan_->fits(sources, targets, delta, accuracy))
    plan_ = TreePlan::make(sources, targets, delta, accuracy);
  plan_->sum(sources, terms, ranks, result);
}

}  // namespace foamsim
