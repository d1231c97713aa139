#pragma once

#include <array>
#include <vector>

#include "LosTopos/mesh/surface_mesh.h"
#include "LosTopos/shapes/triple_junction.h"

namespace lostopos::test {

/// A tetrahedron (0,0,0), (s,0,0), (0,s,0), (0,0,s) moved by `shift`, bounding region 1 in the air: volume s³/6.
SurfaceMesh corner_tetrahedron(double size = 1, const Vec3& shift = Vec3::Zero());
/// The same, added to a mesh as region `inside` in region `outside`.
void add_corner_tetrahedron(SurfaceMesh& mesh, double size, const Vec3& shift, Region inside, Region outside);

/// A sphere of radius R about `centre`, region 1 in the air: n belts of triangles from pole to pole on the x axis, 2n
/// segments around.
SurfaceMesh globe(double radius, long n, const Vec3& centre = Vec3::Zero());

/// An open tube of radius R about the x axis, region 1 inside: `segments` around, `rings` + 1 rings of vertices at
/// distances of `spacing` along x. Vertex index: ring · segments + segment.
SurfaceMesh open_cylinder(double radius, long segments, long rings, double spacing);

using lostopos::triple_junction;
using lostopos::TripleJunction;

}  // namespace lostopos::test
