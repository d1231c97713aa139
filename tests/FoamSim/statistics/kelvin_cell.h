#pragma once

#include "LosTopos/mesh/surface_mesh.h"

namespace foamsim::test {

/// Kelvin's cell without its curvature, a truncated octahedron of side √2, as region 1, with the beginning of the films
/// between its 14 neighbours, 2 to 15, along each of its edges.
lostopos::SurfaceMesh kelvin_cell();

}  // namespace foamsim::test
