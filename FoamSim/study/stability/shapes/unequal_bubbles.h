#pragma once

#include "LosTopos/mesh/surface_mesh.h"

namespace foamsim {

/// The standard double bubble of two volumes (L³) at rest: spherical films that meet at 120° on a circle in the plane
/// x = 0, region 1 of volume `volume1` at x < 0. The vertices lie on it exactly; edges are about `edge` (L) long, at
/// least six around the circle. Throws lostopos::InputError for volumes that double_bubble_equilibrium refuses, or edge
/// ≤ 0.
lostopos::SurfaceMesh unequal_double_bubble(double volume1, double volume2, double edge);

}  // namespace foamsim
