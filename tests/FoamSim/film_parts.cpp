#include "film_parts.h"

#include "FoamSim/dynamics/vortex_sheet.h"
#include "FoamSim/effects/surface_tension.h"
#include "FoamSim/sheet/pressure/edge_angle.h"
#include "FoamSim/sheet/pressure/vertex_area/registry.h"
#include "FoamSim/sheet/velocity/registry.h"

namespace foamsim::test {

std::unique_ptr<Effect> tension(double sigma, std::string_view area) {
  return std::make_unique<SurfaceTension>(sigma, std::make_unique<EdgeAngle>(make_vertex_area(area, {})));
}

SimulationParts parts(std::vector<std::unique_ptr<Effect>> effects, std::string_view integrator) {
  return {.effects = std::move(effects),
          .constraints = {},
          .dynamics = std::make_unique<VortexSheet>(make_biot_savart("direct"), make_integrator(integrator))};
}

SimulationParts parts(std::unique_ptr<Effect> effect, std::string_view integrator) {
  std::vector<std::unique_ptr<Effect>> effects;
  effects.push_back(std::move(effect));
  return parts(std::move(effects), integrator);
}

}  // namespace foamsim::test
