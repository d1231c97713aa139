#pragma once

#include "LosTopos/mesh/surface_mesh.h"

namespace foamsim {

/// Three films between regions 1, 2, 3 in a frame: the edges of a prism of height 1 whose outer corners lie at distance
/// 1 from the axis z, 120° apart, and the spokes from them to its ends. The films meet in a Plateau border from end to
/// end, which starts bowed out along x by `displacement` (L, in (−1, 1)) at its middle. 12·4ⁿ triangles. At rest they
/// are flat: area 3, angles of 120°.
lostopos::SurfaceMesh triple_junction_frame(long n, double displacement);

/// Six films between regions 1 to 4 from the edges of a regular tetrahedron, whose corners lie at distance 1 from the
/// origin, to a Plateau vertex that starts at (`displacement`, 0, 0), in (−1/3, 1/3). 6·4ⁿ triangles. At rest the
/// vertex is at the origin, the films are flat, 120° apart, and the four borders meet at arccos(−1/3) = 109.47°; where
/// the first edges of the borders differ in length, the discrete curvature lets the vertex rest off it by O(h̄).
lostopos::SurfaceMesh quad_junction_frame(long n, double displacement);

}  // namespace foamsim
