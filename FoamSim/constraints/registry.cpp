#include "FoamSim/constraints/registry.h"

#include "FoamSim/constraints/fixed_frame.h"
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
       {"wire", "wires hold films and move on prescribed paths; the air goes with them", wire_options(), make_wire}});
  return entries;
}

}  // namespace foamsim
