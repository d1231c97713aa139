#pragma once

#include "FoamSim/sheet/circulation.h"
#include "LosTopos/mesh/surface_mesh.h"

namespace foamsim {

/// Two spheres of radius 1 (icospheres subdivided n times, mirror images of each other) on the x axis, region 1 on the
/// left, 2 on the right, with `gap` (L, > 0) between them at the origin.
lostopos::SurfaceMesh two_bubbles(long n, double gap);

/// Lets each of them fly towards the other: the circulation of a ball that moves with ±`speed` (L/T) along x through
/// air at rest. Inside, the potential is φ = U·x, outside the dipole −(R³/2r³) U·x (x from the centre): on the ball
/// Γ^{10} = (φ_0 − φ_1)/2 = −¾ U·x.
void approach(const lostopos::SurfaceMesh& mesh, double gap, double speed, CirculationField& circulation);

}  // namespace foamsim
