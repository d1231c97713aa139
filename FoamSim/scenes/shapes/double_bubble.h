#pragma once

#include "LosTopos/mesh/surface_mesh.h"

namespace foamsim {

/// The report's start shape (docs/method.md "The report's cases"): two unit spheres of revolution about x, `n` rings
/// from pole to pole and `m` segments around (0: n), overlapping by o = n/8 rings, centres at ∓cos(π o/n) on x; the
/// left cap bounds region 1, the right one region 2, the disc between them is a fan about the origin. n ≥ 8, m = 0 or ≥
/// 3. Triangles: 2m (2(n − o) − 1) + m.
lostopos::SurfaceMesh double_bubble(long n, long m = 0);

}  // namespace foamsim
