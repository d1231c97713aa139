#pragma once

#include "LosTopos/mesh/surface_mesh.h"

namespace foamsim {

/// Turns a foam (x, y, z) → (z, y, −x) and holds it by two rings, the vertices at edge distance 2 from those with the
/// least and the greatest x, moved to the circle that fits each best: about their mean, in the plane across the
/// eigenvector of Σ_{i<j} n nᵀ with the largest eigenvalue, n = (x_i − mean) × (x_j − mean), their mean distance its
/// radius. Throws base::InputError for a foam that has no such rings.
void hold_by_rings(lostopos::SurfaceMesh& mesh);

}  // namespace foamsim
