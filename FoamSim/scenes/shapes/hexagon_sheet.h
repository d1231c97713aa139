#pragma once

#include "LosTopos/mesh/surface_mesh.h"

namespace foamsim {

/// A film across a regular hexagon of radius 1 in the plane y = 0.2, corners at (±1, ·, 0) and (±½, ·, ±√3/2), six
/// triangles about its centre subdivided n times, labels (1, 0). Its border is then lowered by 0.6 z², and all of it is
/// held: 6·2ⁿ vertices.
lostopos::SurfaceMesh hexagon_sheet(long n);

}  // namespace foamsim
