#pragma once

#include <array>

#include "LosTopos/mesh/surface_mesh.h"

namespace lostopos::test {

/// Adds a copy of `part`, shifted, with region 1 named `region`.
void add_copy(SurfaceMesh& mesh, const SurfaceMesh& part, const Vec3& shift, Region region);

/// Two icospheres of radius 1 (n subdivisions) on the x axis that are `gap` apart.
SurfaceMesh two_spheres(long n, double gap, Region left, Region right);

/// Two tetrahedra whose faces with corners 0, 1, 2 and 4, 5, 6 face each other, `gap` apart; corner i of the one is
/// nearest to corner i + 4 of the other.
SurfaceMesh corner_tetrahedron_pair(double gap, Region first = Region(1), Region second = Region(2));

/// Square columns of the given regions around the z axis: the quadrants of the box [−1, 1]² × [0, 1] about four films
/// that meet in one line, in the order of a turn; the air is around the box.
SurfaceMesh four_columns(const std::array<Region, 4>& regions);

/// Total area of the films between regions a and b.
double film_area(const SurfaceMesh& mesh, Region a, Region b);

/// Whether every two regions at every vertex have a film between them there.
bool all_complete(const SurfaceMesh& mesh);

}  // namespace lostopos::test
