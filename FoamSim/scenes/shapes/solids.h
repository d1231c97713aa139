#pragma once

#include "LosTopos/shapes/solids.h"

namespace foamsim {

using lostopos::cube;
using lostopos::icosphere;
using lostopos::tetrahedron;

/// Multiplies every vertex's coordinates by `factors`, all > 0.
void scale(lostopos::SurfaceMesh& mesh, const lostopos::Vec3& factors);

/// An icosphere of n subdivisions about the origin, scaled to the half axes (L, > 0).
lostopos::SurfaceMesh ellipsoid(long n, const lostopos::Vec3& half_axes);

/// The mesh inverted in the origin, x → −x; every triangle keeps its regions.
lostopos::SurfaceMesh mirrored(const lostopos::SurfaceMesh& mesh);

/// Moves every vertex along its direction from the origin by the factor 1 + amplitude · P_mode(x/|x|): a bubble in its
/// axisymmetric oscillation mode about the x axis. `mode` ≥ 1, `amplitude` relative to the radius.
void perturb_with_mode(lostopos::SurfaceMesh& mesh, long mode, double amplitude);

}  // namespace foamsim
