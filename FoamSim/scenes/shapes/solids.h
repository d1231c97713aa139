#pragma once

#include "LosTopos/mesh/surface_mesh.h"

namespace foamsim {

/// An icosahedron subdivided n times, every vertex pushed out to the sphere of the given radius (L) about the origin:
/// 20·4ⁿ triangles, region 1 in the air.
lostopos::SurfaceMesh icosphere(long n, double radius = 1);

/// A regular tetrahedron with its corners at distance `radius` (L) from the origin, its flat faces subdivided n times:
/// 4·4ⁿ triangles.
lostopos::SurfaceMesh tetrahedron(long n, double radius = 1);

/// A cube with its corners at distance `radius` (L) from the origin, its flat faces (two triangles each) subdivided n
/// times: 12·4ⁿ triangles.
lostopos::SurfaceMesh cube(long n, double radius = 1);

/// Moves every vertex along its direction from the origin by the factor 1 + amplitude · P_mode(x/|x|): a bubble in its
/// axisymmetric oscillation mode about the x axis. `mode` ≥ 1, `amplitude` relative to the radius.
void perturb_with_mode(lostopos::SurfaceMesh& mesh, long mode, double amplitude);

}  // namespace foamsim
