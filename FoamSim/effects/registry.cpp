#include "FoamSim/effects/registry.h"

#include <algorithm>

#include "FoamSim/effects/damping.h"
#include "FoamSim/effects/diffusion.h"
#include "FoamSim/effects/growth.h"
#include "FoamSim/effects/surface_tension.h"
#include "FoamSim/effects/volumes.h"

namespace foamsim {
namespace {

using Made = std::unique_ptr<Effect>;

base::OptionSpec damping_option() {
  return {"damping", 1.0, "factor d by which circulation decays in a unit of time; 1: none", "a number in (0, 1]",
          [](const base::OptionValue& value) { return std::get<double>(value) > 0 && std::get<double>(value) <= 1; }};
}

Made make_surface_tension(const EffectSetup& setup) {
  if (setup.options.word("dynamics") != "vortex-sheet" && setup.options.word("forces") != "pressure-scheme")
    return std::make_unique<SurfaceTension>(setup.options.number("sigma"), nullptr);
  const PressureEntry& pressures = setup.sheet.pressures.find(setup.options.word("pressure"));
  return std::make_unique<SurfaceTension>(setup.options.number("sigma"),
                                          pressures.make({setup.options, setup.resolution, setup.sheet.areas}));
}

base::Registry<EffectEntry> make_entries() {
  return base::Registry<EffectEntry>(
      "effect",
      {{"surface_tension",
        "curved films drive the air: circulation grows by the jump of the pressure scheme's values",
        {base::non_negative_number("sigma", 1, "surface tension over density of one film side, L^3/T^2")},
        make_surface_tension},
       {"damping",
        "circulation decays everywhere by the same factor",
        {damping_option(), base::non_negative_number("damping_from", 0, "time from which damping acts, T")},
        [](const EffectSetup& setup) -> Made {
          return std::make_unique<Damping>(setup.options.number("damping"), setup.options.number("damping_from"));
        }},
       {"diffusion",
        "circulation is smoothed along each film",
        {base::non_negative_number("diffusion", 10, "rate s of smoothing of circulation, 1/T")},
        [](const EffectSetup& setup) -> Made {
          return std::make_unique<Diffusion>(setup.options.number("diffusion"));
        }},
       {"volumes",
        "bubbles keep their volumes to rounding, but for what other effects change",
        {},
        [](const EffectSetup&) -> Made { return std::make_unique<Volumes>(); }},
       {"growth",
        "bubbles grow: films towards the air move along their normals until bubbles meet and press into a foam",
        {base::non_negative_number("growth", 0.5, "speed of the films, L/T")},
        [](const EffectSetup& setup) -> Made { return std::make_unique<Growth>(setup.options.number("growth")); }}});
}

}  // namespace

const base::Registry<EffectEntry>& built_in_effects() {
  static const base::Registry<EffectEntry> entries = make_entries();
  return entries;
}

std::vector<std::unique_ptr<Effect>> make_effects(const base::Registry<EffectEntry>& registry,
                                                  std::span<const std::string> names, const EffectSetup& setup) {
  for (const std::string& name : names) registry.find(name);
  std::vector<std::unique_ptr<Effect>> effects;
  for (const EffectEntry& entry : registry)
    if (std::ranges::find(names, entry.name) != names.end()) effects.push_back(entry.make(setup));
  return effects;
}

}  // namespace foamsim
