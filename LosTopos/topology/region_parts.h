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

/// What is too small to be a part of a region, in L.
struct SmallParts {
  double diagonal = 0;  ///< a box with one shorter than this
  /// A tetrahedron, which has no smaller boundary to change to, that no ball of this diameter fits into.
  double thickness = 0;
};
/// The parts that are too small, ordered by their first triangle. Pieces of boundary that share an edge are one part.
std::vector<RegionPart> small_region_parts(const SurfaceMesh& mesh, const SmallParts& small);

/// What the boundary of a region looks like as a whole, as it is seen from within (see RegionSurface).
struct RegionShape {
  std::size_t pieces = 0;   ///< of the boundary that do not have the region inside
  std::size_t pockets = 0;  ///< pieces that have
  double tunnels = 0;       ///< through the pieces: their genus; where films end, see RegionSurface::Piece
};
/// Costs a walk over the mesh.
RegionShape region_shape(const SurfaceMesh& mesh, Region region);

/// What counts as an opening, L.
struct Openings {
  double pocket = 0;  ///< one with more than the volume of a ball of this diameter
  double tunnel = 0;  ///< one not all of which is within this radius (see `wide_tunnels`)
};
/// Whether what the region surrounds is one solid without openings. A pit is none, however narrow its mouth. False for
/// films that end somewhere.
bool surrounds_one_solid(const SurfaceMesh& mesh, Region region, const Openings& least);

}  // namespace lostopos
