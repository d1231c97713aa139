#pragma once

#include "LosTopos/mesh/surface_mesh.h"

namespace foamsim {

/// Two spheres of radius 1 (icospheres subdivided n times, mirror images of each other) on the x axis, region 1 on the
/// left, 2 on the right, with `gap` (L, > 0) between them at the origin.
lostopos::SurfaceMesh two_bubbles(long n, double gap);

}  // namespace foamsim
