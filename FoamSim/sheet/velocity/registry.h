#pragma once

#include "Base/options/option_set.h"
#include "Base/parallel/ranks.h"
#include "Base/registry/registry.h"
#include "FoamSim/sheet/velocity/biot_savart.h"

namespace foamsim {

/// What a velocity sum may be made from: the options, with its own, and the processes among which sums are shared out.
struct VelocitySetup {
  const base::OptionSet& options;
  std::shared_ptr<const base::Ranks> ranks = base::alone();
};
using VelocityEntry = base::Model<BiotSavart, VelocitySetup>;

/// The built-in sums: direct, tree, auto.
const base::Registry<VelocityEntry>& velocity_sums();

/// A built-in sum with the defaults of its options. Throws base::InputError naming the valid ones.
std::unique_ptr<BiotSavart> make_biot_savart(std::string_view name);

}  // namespace foamsim
