#pragma once

#include <array>
#include <vector>

#include "LosTopos/mesh/surface_mesh.h"

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

/// Three flat films that meet along the x axis.
struct TripleJunction {
  SurfaceMesh mesh;
  std::vector<Vertex> border;     ///< on the axis, ascending in x; the first and the last are ends
  std::array<Vec3, 3> direction;  ///< in which film i leaves the axis, unit vectors in the yz plane
};
/// Film i separates region i from region (i + 1) mod 3, and region i spans the angle `degrees[i]` between films i − 1
/// and i; the angles add up to 360. Square grids of spacing 1 with one diagonal each, 7 vertices along the border and 4
/// rows off it; film `stretched` has its rows pulled out to `stretch` times their distance, in its own plane.
TripleJunction triple_junction(const std::array<double, 3>& degrees, int stretched = 0, double stretch = 1);

}  // namespace lostopos::test
