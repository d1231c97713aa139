#include "FoamSim/constraints/registry.h"

#include <algorithm>

#include "FoamSim/constraints/fixed_frame.h"
#include "FoamSim/constraints/rod.h"
#include "FoamSim/constraints/wire.h"

namespace foamsim {

namespace {

std::vector<base::OptionSpec> wire_options() {
  return {
      {"wires", std::vector<std::string>{},
       "how held vertices move, 'SELECTION: MOTION [from T] [until T]', separated by commas; others stand still",
       "texts as 'held and x < 0: move -0.08 0 0 until 2.5', 'free-edges: still' or 'held: pull 0.04'"},
      base::flag("wire_interior", true, "circulation where wires hold films in their middle, so that the air follows"),
      base::flag("open_boundary", false, "vortices along wires at which films end, so that the air follows"),
      base::positive_number("wire_weight", 0.1, "regularises the first, in resolutions; less: the air follows closer"),
      base::positive_number("open_weight", 0.1, "regularises the second, T/L^2")};
}

std::unique_ptr<Constraint> make_wire(const ConstraintSetup& setup) {
  std::vector<WireSpec> wires;
  for (const std::string& text : setup.options.words("wires")) wires.emplace_back(text);
  const WireAirOptions air{.interior = setup.options.flag("wire_interior"),
                           .open_boundary = setup.options.flag("open_boundary"),
                           .interior_weight = setup.options.number("wire_weight") * setup.resolution,
                           .open_weight = setup.options.number("open_weight")};
  const double dt = setup.options.has("dt") ? setup.options.number("dt") : 0;
  return std::make_unique<Wire>(std::move(wires), air, setup.resolution, dt);
}

std::vector<base::OptionSpec> rod_options() {
  const RodMaterial d;
  return {base::positive_number("rod_radius", d.radius, "radius of the rod, in the rod's units"),
          base::positive_number("rod_density", d.density, "its mass over volume"),
          base::non_negative_number("stretching", d.stretching, "spring constant of its segments"),
          base::non_negative_number("bending", d.bending, "its resistance to bending"),
          base::non_negative_number("rod_damping", d.damping, "drag that comes with bending"),
          {"gravity", d.gravity, "weight over mass of the rod, towards -z", "a finite number"},
          base::flag("looped", true, "whether the rod is closed"),
          {"rod_fixed", std::string(), "a selection of the rod's vertices that do not move; empty: none",
           "a text as 'held and z > 0.85'"},
          base::positive_number("air_density", 1.2, "what makes forces of films, 4 sigma times this, those on the rod"),
          base::flag("reference_units", false,
                     "films pull with sigma alone and the rod makes two steps in each, as in the reference program"),
          base::flag("rod_open_boundary", false, "vortices along the rod, so that the air follows it")};
}

std::unique_ptr<Constraint> make_rod(const ConstraintSetup& setup) {
  const base::OptionSet& options = setup.options;
  RodOptions own{.material = {.radius = options.number("rod_radius"),
                              .density = options.number("rod_density"),
                              .stretching = options.number("stretching"),
                              .bending = options.number("bending"),
                              .damping = options.number("rod_damping"),
                              .gravity = options.number("gravity")},
                 .looped = options.flag("looped"),
                 .reference = options.flag("reference_units")};
  if (!options.word("rod_fixed").empty()) own.fixed.emplace(options.word("rod_fixed"));
  const auto& effects = options.words("effects");
  if (std::ranges::find(effects, "surface_tension") != effects.end())
    own.pull = options.number("sigma") * (own.reference ? 1 : 4 * options.number("air_density"));
  return std::make_unique<Rod>(own, WireAirOptions{.open_boundary = options.flag("rod_open_boundary"),
                                                   .interior_weight = 0.1 * setup.resolution});
}

}  // namespace

const base::Registry<ConstraintEntry>& constraints() {
  static const base::Registry<ConstraintEntry> entries(
      "constraint",
      {{"frame",
        "films that end at a free edge end at a frame that stands still",
        {},
        [](const ConstraintSetup& setup) -> std::unique_ptr<Constraint> {
          if (setup.edges.empty()) return nullptr;
          return std::make_unique<FixedFrame>(setup.edges);
        }},
       {"wire", "wires hold films and move on prescribed paths; the air goes with them", wire_options(), make_wire},
       {"rod", "an elastic rod carries the films' border, with weight and their pull", rod_options(), make_rod}});
  return entries;
}

}  // namespace foamsim
