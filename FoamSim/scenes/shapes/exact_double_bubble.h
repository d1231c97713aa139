#pragma once

#include "FoamSim/scenes/shapes/double_bubble_equilibrium.h"
#include "LosTopos/mesh/surface_mesh.h"

namespace foamsim {

/// A mesh whose vertices lie exactly on a standard double bubble: bubble 0 is region 1 and lies towards −x, bubble 1 is
/// region 2, and the films meet in the plane x = 0. `segments` edges around the circle, ≥ 6, and edges about as long
/// elsewhere. What a measure finds on it besides the closed form's values is the measure's own error.
lostopos::SurfaceMesh exact_double_bubble(const DoubleBubbleEquilibrium& equilibrium, long segments);

}  // namespace foamsim
