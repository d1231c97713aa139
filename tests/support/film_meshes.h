#pragma once

#include <vector>

#include "LosTopos/mesh/surface_mesh.h"

namespace lostopos::test {

/// The equilibrium of two equal bubbles in closed form: two caps of radius r about (∓r/2, 0, 0), regions 1 and 2, that
/// meet a disc in the plane x = 0 at 120°, on a circle of radius r √3/2. All vertices lie on it exactly. `segments`
/// edges around the circle, ≥ 6; the other edges are about as long.
SurfaceMesh analytic_double_bubble(double radius, long segments);

/// Its exact volume of one bubble: 9π r³ / 8.
double analytic_bubble_volume(double radius);

/// Twelve flat films from the edges of the cube [−1, 1]³ to its centre, k² triangles each, between six regions, one at
/// each face; eight lines of three films meet in the centre. The films end at the cube's edges;
/// vertex 0 is the centre.
struct CubeFrame {
  SurfaceMesh mesh;
  std::vector<Vertex> frame;  ///< the vertices on the cube's edges
};
CubeFrame cube_frame(long k);

/// Whether two meshes are the same to the bit: slots, gaps, positions, labels and the order of incidence.
bool same_bits(const SurfaceMesh::State& a, const SurfaceMesh::State& b);

}  // namespace lostopos::test
