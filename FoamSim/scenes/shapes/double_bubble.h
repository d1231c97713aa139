#pragma once

#include "LosTopos/mesh/surface_mesh.h"

namespace foamsim {

/// The report's start shape (docs/method.md "The report's cases"): two unit spheres of revolution about x, `n` rings
/// from pole to pole and `n` segments around, overlapping by o = n/8 rings, centres at ∓cos(π o/n) on x; the left cap
/// bounds region 1, the right one region 2, the disc between them is a fan about the origin. n ≥ 8. Triangles: 2n (2(n
/// − o) − 1) + n.
lostopos::SurfaceMesh double_bubble(long n);

}  // namespace foamsim
