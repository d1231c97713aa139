#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "Base/options/option_set.h"
#include "Base/registry/registry.h"
#include "FoamSim/effects/effect.h"
#include "FoamSim/sheet/sheet_models.h"

namespace foamsim {

/// What an effect may be made from.
struct EffectSetup {
  const base::OptionSet& options;
  double resolution;                 ///< h̄, L
  const SheetModels& sheet;          ///< pressure schemes and what else is chosen by name
  bool tension_by_dynamics = false;  ///< see Dynamics::takes_tension
};
using EffectEntry = base::Model<Effect, EffectSetup>;

/// The built-in effects, in the order in which they act within a step. A new one is a file beside this and an entry
/// here, or an entry that a program adds to its own catalogue.
const base::Registry<EffectEntry>& built_in_effects();

/// The effects with these names, in the registry's order. Throws base::InputError for an unknown name.
std::vector<std::unique_ptr<Effect>> make_effects(const base::Registry<EffectEntry>& registry,
                                                  std::span<const std::string> names, const EffectSetup& setup);

}  // namespace foamsim
