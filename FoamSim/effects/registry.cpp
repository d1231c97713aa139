#include "FoamSim/effects/registry.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "FoamSim/effects/blow.h"
#include "FoamSim/effects/burst.h"
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
  if (setup.tension_by_dynamics) return std::make_unique<SurfaceTension>(setup.options.number("sigma"), nullptr);
  if (setup.options.word("dynamics") != "vortex-sheet" && setup.options.word("forces") != "pressure-scheme")
    return std::make_unique<SurfaceTension>(setup.options.number("sigma"), nullptr);
  const PressureEntry& pressures = setup.sheet.pressures.find(setup.options.word("pressure"));
  return std::make_unique<SurfaceTension>(setup.options.number("sigma"),
                                          pressures.make({setup.options, setup.resolution, setup.sheet.areas}));
}

// Lists of numbers are given as words.
bool are_numbers(const base::OptionValue& value) {
  const auto& words = std::get<base::Words>(value);
  return std::ranges::all_of(words, [](const std::string& word) {
    double number = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    return error == std::errc() && end == word.data() + word.size() && number >= 0 && std::isfinite(number);
  });
}

bool are_whole_numbers(const base::OptionValue& value) {
  const auto& words = std::get<base::Words>(value);
  return are_numbers(value) && std::ranges::all_of(words, [](const std::string& word) {
           return word.size() <= 9 && word.find_first_not_of("0123456789") == std::string::npos;
         });
}

std::vector<base::OptionSpec> burst_options() {
  const std::vector<std::string> none;
  return {
      base::non_negative_number("burst_start", 5, "time of the first burst, T"),
      base::positive_number("burst_interval", 10, "time from one burst to the next, T"),
      {"burst_times", none, "times of the bursts in place of these two, T", "numbers >= 0 that ascend", are_numbers},
      {"burst_region", none, "regions that burst, in turn; none: at random, by seed",
       "numbers of regions, whole and > 0", are_whole_numbers}};
}

Made make_burst(const EffectSetup& setup) {
  BurstSchedule schedule{.start = setup.options.number("burst_start"),
                         .interval = setup.options.number("burst_interval"),
                         .seed = static_cast<std::uint64_t>(setup.options.whole("seed"))};
  for (const std::string& time : setup.options.words("burst_times")) schedule.times.push_back(std::stod(time));
  for (const std::string& region : setup.options.words("burst_region"))
    schedule.regions.emplace_back(static_cast<std::uint32_t>(std::stoul(region)));
  return std::make_unique<Burst>(std::move(schedule));
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
        {base::non_negative_number("growth", 0.5, "speed of the films, L/T"),
         base::word_from("growth_normals", std::string("area-weighted"),
                         "along which: area-weighted, in the step, or the mean of unit normals, before it", "normals",
                         {"area-weighted", "unit"})},
        [](const EffectSetup& setup) -> Made {
          return std::make_unique<Growth>(setup.options.number("growth"), setup.options.word("growth_normals") == "unit"
                                                                              ? GrowthNormals::unit
                                                                              : GrowthNormals::area_weighted);
        }},
       {"blow",
        "air is blown in at held vertices, a straw's",
        {base::non_negative_number("blow_rate", 20, "growth of circulation there, L^2/T^2"),
         base::whole_number("blow_region", 1, 1, "the region that is blown up"),
         base::non_negative_number("blow_until", 0, "time at which it ends, T; 0: never"),
         {"blow_where", std::string("held"), "the straw: held vertices among these, as wires name them",
          "a selection"}},
        [](const EffectSetup& setup) -> Made {
          return std::make_unique<Blow>(
              BlowOptions{.rate = setup.options.number("blow_rate"),
                          .region = lostopos::Region(static_cast<std::uint32_t>(setup.options.whole("blow_region"))),
                          .until = setup.options.number("blow_until"),
                          .where = setup.options.word("blow_where")});
        }},
       {"burst", "bubbles burst one by one: their films towards the air break", burst_options(), make_burst}});
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
