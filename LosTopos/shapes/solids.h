#pragma once

#include "LosTopos/mesh/surface_mesh.h"

namespace lostopos {

/// An icosahedron subdivided n times, every vertex pushed out to the sphere of the given radius (L) about the origin:
/// 20·4ⁿ triangles, region 1 in the air.
SurfaceMesh icosphere(long n, double radius = 1);

/// A regular tetrahedron with its corners at distance `radius` (L) from the origin, its flat faces subdivided n times:
/// 4·4ⁿ triangles.
SurfaceMesh tetrahedron(long n, double radius = 1);

/// A cube with its corners at distance `radius` (L) from the origin, its flat faces (two triangles each) subdivided n
/// times: 12·4ⁿ triangles.
SurfaceMesh cube(long n, double radius = 1);

}  // namespace lostopos
