#pragma once

#include <array>
#include <vector>

#include "LosTopos/mesh/surface_mesh.h"

namespace lostopos {

/// Three flat films that meet along the x axis.
struct TripleJunction {
  SurfaceMesh mesh;
  std::vector<Vertex> border;     ///< on the axis, ascending in x; the first and the last are ends
  std::array<Vec3, 3> direction;  ///< in which film i leaves the axis, unit vectors in the yz plane
};
/// Film i separates region i from region (i + 1) mod 3, and region i spans the angle `degrees[i]` between films i − 1
/// and i; the angles add up to 360. Square grids of spacing 1 with one diagonal each, 7 vertices along the border and 4
/// rows off it; film `stretched` has its rows pulled out to `stretch` times their distance, in its own plane.
TripleJunction triple_junction(const std::array<double, 3>& degrees, int stretched = 0, double stretch = 1);

}  // namespace lostopos
