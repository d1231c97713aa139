#pragma once

#include "FoamSim/sheet/pressure/pressure_scheme.h"
#include "FoamSim/sheet/pressure/vertex_area/registry.h"

namespace foamsim {

/// What a pressure scheme may be made from.
struct PressureSetup {
  const base::OptionSet& options;
  double resolution;  ///< h̄, L
  const base::Registry<VertexAreaEntry>& areas;
};
using PressureEntry = base::Model<PressureScheme, PressureSetup>;

/// The built-in schemes: edge_angle, with the area strategy that the option `area` names.
const base::Registry<PressureEntry>& pressure_schemes();

}  // namespace foamsim
