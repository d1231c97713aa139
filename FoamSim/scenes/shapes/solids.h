#pragma once

#include "LosTopos/shapes/solids.h"

namespace foamsim {

using lostopos::cube;
using lostopos::icosphere;
using lostopos::tetrahedron;

/// Moves every vertex along its direction from the origin by the factor 1 + amplitude · P_mode(x/|x|): a bubble in its
/// axisymmetric oscillation mode about the x axis. `mode` ≥ 1, `amplitude` relative to the radius.
void perturb_with_mode(lostopos::SurfaceMesh& mesh, long mode, double amplitude);

}  // namespace foamsim
