#include "FoamSim/sheet/pressure/vertex_area/registry.h"

#include "FoamSim/sheet/pressure/vertex_area/averaged.h"
#include "FoamSim/sheet/pressure/vertex_area/border_length.h"
#include "FoamSim/sheet/pressure/vertex_area/constant_edge.h"
#include "FoamSim/sheet/pressure/vertex_area/naive.h"

namespace foamsim {
namespace {

template <class Strategy>
std::unique_ptr<VertexArea> make(const VertexAreaSetup&) {
  return std::make_unique<Strategy>();
}

base::Registry<VertexAreaEntry> make_strategies() {
  return base::Registry<VertexAreaEntry>(
      "area strategy",
      {{"naive", "each region by its own triangles; a double bubble drifts away", {}, make<NaiveArea>},
       {"constant-edge",
        "phi times mean edge times junction length; stable, wrong angles",
        {base::positive_number("phi", 0.5, "constant-edge's factor phi, dimensionless")},
        [](const VertexAreaSetup& setup) -> std::unique_ptr<VertexArea> {
          return std::make_unique<ConstantEdgeArea>(setup.options.number("phi"), setup.resolution);
        }},
       {"averaged", "mean over the regions; stable, angles converge to 120 degrees", {}, make<AveragedArea>},
       {"border-length",
        "averaged, shared out by border length; balanced at Plateau vertices too",
        {},
        make<BorderLengthArea>}});
}

}  // namespace

const base::Registry<VertexAreaEntry>& vertex_area_strategies() {
  static const base::Registry<VertexAreaEntry> strategies = make_strategies();
  return strategies;
}

std::unique_ptr<VertexArea> make_vertex_area(std::string_view name, const VertexAreaOptions& options) {
  const VertexAreaEntry& entry = vertex_area_strategies().find(name);
  base::OptionSet own(entry.options);
  for (const base::OptionSpec& spec : entry.options)
    if (spec.key == "phi") own.set("phi", options.phi, "");
  return entry.make({own, options.resolution});
}

}  // namespace foamsim
