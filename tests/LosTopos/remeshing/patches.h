#pragma once

#include "LosTopos/mesh/surface_mesh.h"
#include "LosTopos/remeshing/remesh_options.h"

namespace lostopos::test {

inline constexpr Labels film{Region(1), air};

/// Vertices 0 and 1 joined by an edge, 2 and 3 opposite to it: triangles (0, 1, 2) and (1, 0, 3).
SurfaceMesh two_triangles(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// A flat patch of equilateral triangles of side 1 in the plane z = 0: `rings` rings of them around vertex 0, which is
/// at the origin.
SurfaceMesh hexagonal_patch(int rings);

/// Six triangles from an apex, vertex 0, at (0, 0, height) to a regular hexagon of radius 1 in the plane z = 0.
SurfaceMesh tent(double height);

/// A tetrahedron of the given size about `centre`, of its own region 7 in `outside`.
void add_pebble(SurfaceMesh& mesh, const Vec3& centre, double size, Region outside);

/// Options in which nothing of size one breaks a bound.
RemeshOptions wide_bounds();

/// Volume of a region; NaN when there is none such.
double volume(const SurfaceMesh& mesh, Region region);

/// The first edge, in slot order, for which `wanted` holds; invalid when there is none.
template <class Predicate>
Edge first_edge(const SurfaceMesh& mesh, Predicate wanted) {
  for (Edge e : mesh.edges())
    if (wanted(e)) return e;
  return {};
}

}  // namespace lostopos::test
