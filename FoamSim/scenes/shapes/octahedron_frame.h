#pragma once

#include <cstdint>

#include "LosTopos/mesh/surface_mesh.h"

namespace foamsim {

/// Films in the frame of an octahedron with its corners at ±1 on the axes: 24 triangles between eight regions, one
/// behind each face. Regions 5 to 8 lie behind every other face and have a point T_i of their own, 0.3 of the signs of
/// their octant; regions 1 to 4 meet at a point at random in [−0.1, 0.1]³. Six films join that point to two of the T_i,
/// six a corner of the frame to two of them, twelve an edge of the frame to one. Solid caps, three triangles to a tip
/// at ½(±1, ±1, ±1) before each face, close the regions. The 6 corners and 8 tips are held. The same seed gives the
/// same bits.
lostopos::SurfaceMesh octahedron_frame(std::uint64_t seed);

}  // namespace foamsim
