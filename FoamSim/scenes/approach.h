#pragma once

#include "FoamSim/sheet/circulation.h"

namespace foamsim {

/// Lets the two bubbles of scenes/shapes/two_bubbles.h, `gap` (L) from each other, fly towards each other: the
/// circulation of a ball that moves with ±`speed` (L/T) along x through air at rest. Inside, the potential is φ = U·x,
/// outside the dipole −(R³/2r³) U·x (x from the centre): on the ball Γ^{10} = (φ_0 − φ_1)/2 = −¾ U·x.
void approach(const lostopos::SurfaceMesh& mesh, double gap, double speed, CirculationField& circulation);

}  // namespace foamsim
