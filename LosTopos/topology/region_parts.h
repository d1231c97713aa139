#pragma once

#include <vector>

#include "LosTopos/mesh/surface_mesh.h"

namespace lostopos {

/// A connected piece of a region's boundary: a bubble, or a pocket of the air between bubbles.
struct RegionPart {
  Region region;
  std::vector<Triangle> boundary;  ///< ascending
  std::vector<Region> neighbours;  ///< on the other side, ascending
  Vec3 centre = Vec3::Zero();      ///< of its box, L
};

/// The parts whose boxes have a diagonal shorter than `largest` (L), ordered by their first triangle. Pieces of
/// boundary that share an edge are one part.
std::vector<RegionPart> small_region_parts(const SurfaceMesh& mesh, double largest);

}  // namespace lostopos
