#include "FoamSim/effects/registry.h"

#include <algorithm>

#include "Base/names/nearest_name.h"
#include "FoamSim/effects/damping.h"
#include "FoamSim/effects/diffusion.h"
#include "FoamSim/effects/growth.h"
#include "FoamSim/effects/surface_tension.h"
#include "FoamSim/sheet/pressure/vertex_area/registry.h"

namespace foamsim {
namespace {

using Made = std::unique_ptr<Effect>;

base::OptionSpec area_option() {
  base::OptionSpec spec{"area", std::string("averaged"),
                        "area that normalises curvature at junctions (see 'foamsim effects')", ""};
  for (const VertexAreaEntry& entry : vertex_area_strategies())
    spec.allowed += (spec.allowed.empty() ? "one of " : ", ") + std::string(entry.name);
  return spec;
}

base::OptionSpec damping_option() {
  return {"damping", 1.0, "factor d by which circulation decays in a unit of time; 1: none", "a number in (0, 1]",
          [](const base::OptionValue& value) { return std::get<double>(value) > 0 && std::get<double>(value) <= 1; }};
}

Made make_surface_tension(const EffectSetup& setup) {
  const VertexAreaOptions area{setup.options.number("phi"), setup.resolution};
  return std::make_unique<SurfaceTension>(
      setup.options.number("sigma"),
      std::make_unique<EdgeAngleCurvature>(make_vertex_area(setup.options.word("area"), area)));
}

std::vector<EffectEntry> make_entries() {
  std::vector<EffectEntry> entries{
      {"surface_tension",
       "curved films drive the air: circulation grows by sigma times the jump of curvature",
       {base::non_negative_number("sigma", 1, "surface tension over density of one film side, L^3/T^2"), area_option(),
        base::positive_number("phi", 0.5, "constant-edge's factor phi, dimensionless")},
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
       [](const EffectSetup& setup) -> Made { return std::make_unique<Diffusion>(setup.options.number("diffusion")); }},
      {"growth",
       "bubbles grow: films towards the air move along their normals until bubbles meet and press into a foam",
       {base::non_negative_number("growth", 0.5, "speed of the films, L/T")},
       [](const EffectSetup& setup) -> Made { return std::make_unique<Growth>(setup.options.number("growth")); }},
  };
  for (EffectEntry& entry : entries)
    for (base::OptionSpec& spec : entry.options) spec.effect = entry.name;
  return entries;
}

}  // namespace

const std::vector<EffectEntry>& effect_entries() {
  static const std::vector<EffectEntry> entries = make_entries();
  return entries;
}

std::vector<std::unique_ptr<Effect>> make_effects(std::span<const std::string> names, const EffectSetup& setup) {
  for (const std::string& name : names) base::find_by_name(effect_entries(), name, "effect");
  std::vector<std::unique_ptr<Effect>> effects;
  for (const EffectEntry& entry : effect_entries())
    if (std::ranges::find(names, entry.name) != names.end()) effects.push_back(entry.make(setup));
  return effects;
}

}  // namespace foamsim
