#pragma once

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "Base/options/option_set.h"
#include "FoamSim/effects/effect.h"

namespace foamsim {

/// What an effect may be made from: the scene's options and the resolved h̄ (L).
struct EffectSetup {
  const base::OptionSet& options;
  double resolution;
};

/// An effect as users know it.
struct EffectEntry {
  std::string_view name;
  std::string_view summary;
  std::vector<base::OptionSpec> options;  ///< the options that only this effect reads
  std::unique_ptr<Effect> (*make)(const EffectSetup&);
};

/// All effects, in the order in which they act within a step. A new one is a file beside this and an entry in the
/// table.
const std::vector<EffectEntry>& effect_entries();

/// The effects with these names, in the registry's order. Throws base::InputError for an unknown name.
std::vector<std::unique_ptr<Effect>> make_effects(std::span<const std::string> names, const EffectSetup& setup);

}  // namespace foamsim
