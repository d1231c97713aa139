#pragma once

#include "LosTopos/mesh/surface_mesh.h"

namespace foamsim {

/// Three icospheres of radius 0.5, each of n subdivisions, regions 1 to 3, about (1, 0, 0) and (−½, 0, ∓√3/2).
lostopos::SurfaceMesh three_spheres(long n);

}  // namespace foamsim
