#pragma once

#include <array>

#include "LosTopos/mesh/surface_mesh.h"

namespace foamsim {

/// A block of unit cubes about the origin, each a bubble of its own (regions 1, 2, … with x running fastest), the air
/// around it. Every face is k × k squares of two triangles. cells and k ≥ 1.
lostopos::SurfaceMesh block_of_cubes(const std::array<long, 3>& cells, long k);

/// A ball of radius 1 about the origin cut into four equal bubbles by six flat films: four Plateau borders run from the
/// Plateau vertex in the middle to the corners of a tetrahedron. k ≥ 2 triangles along each border.
struct TetrahedralCluster {
  lostopos::SurfaceMesh mesh;
  lostopos::Vertex middle;
  std::array<lostopos::Vec3, 4> corners;  ///< unit vectors along the borders
};
TetrahedralCluster tetrahedral_cluster(long k);

}  // namespace foamsim
