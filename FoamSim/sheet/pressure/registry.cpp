#include "FoamSim/sheet/pressure/registry.h"

#include "FoamSim/sheet/pressure/edge_angle.h"

namespace foamsim {

const base::Registry<PressureEntry>& pressure_schemes() {
  static const base::Registry<PressureEntry> schemes(
      "pressure scheme", {{"edge_angle",
                           "curvature from the angles at edges over an area: the report's, with its area strategies",
                           {},
                           [](const PressureSetup& setup) -> std::unique_ptr<PressureScheme> {
                             const VertexAreaEntry& area = setup.areas.find(setup.options.word("area"));
                             return std::make_unique<EdgeAngle>(area.make({setup.options, setup.resolution}));
                           }}});
  return schemes;
}

}  // namespace foamsim
