#pragma once

#include "FoamSim/sheet/pressure/registry.h"
#include "FoamSim/sheet/velocity/registry.h"

namespace foamsim {

/// What can be chosen by name of how the sheet is discretised.
struct SheetModels {
  base::Registry<VertexAreaEntry> areas = vertex_area_strategies();
  base::Registry<PressureEntry> pressures = pressure_schemes();
  base::Registry<VelocityEntry> velocities = velocity_sums();
  std::shared_ptr<const base::Ranks> ranks = base::alone();  ///< the processes that share out the velocity sums
};

}  // namespace foamsim
