#pragma once

#include "LosTopos/mesh/surface_mesh.h"

namespace foamsim {

/// Three flat films, rectangles from the axis between (0, 0, 0) and (0, 1, 0) to (2, ·, 0) and (−½, ·, ∓√3/2), with the
/// regions (0, 1), (1, 2), (2, 0) on their sides. 6·4ⁿ triangles, free edges all around. In balance: the films meet at
/// 120°, and where they end nothing pulls.
lostopos::SurfaceMesh free_triple_junction(long n);

/// Six films between regions 0 to 3 about a vertex 0.7·v₁ off the origin, v₁…v₄ = (−1, 0, −a), (1, 0, −a), (0, −1, a),
/// (0, 1, a), a = 1/√2: for each pair ij the quadrilateral vertex, v_i, o_ij, v_j, in two triangles, where o₁₂ = (0, 0,
/// −2a), o₁₃ = (−1, −1, 0), o₁₄ = (−1, 1, 0), o₂₃ = (1, −1, 0), o₂₄ = (1, 1, 0), o₃₄ = (0, 0, 2a). 12·4ⁿ triangles,
/// free edges all around. Without the displacement it is in balance.
lostopos::SurfaceMesh free_quad_junction(long n);

}  // namespace foamsim
