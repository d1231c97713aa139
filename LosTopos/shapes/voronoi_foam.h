#pragma once

#include <cstdint>

#include "LosTopos/mesh/surface_mesh.h"

namespace lostopos {

struct VoronoiFoamOptions {
  long cells = 20;         ///< bubbles, > 0
  std::uint64_t seed = 1;  ///< of the random points
  int relaxations = 3;    ///< rounds of Lloyd's: each point to the middle of its cell; more make the bubbles more alike
  long subdivisions = 0;  ///< of each triangle into four, at its edges' midpoints
  /// Over cells^(-1/3): shorter sides of the films are contracted, by which four borders and more may meet at a point.
  double shortest_side = 0.1;
};

/// A dry foam that fills the unit box: the Voronoi cells of random points are regions 1 to `cells`, the air is outside,
/// so that the walls of the box are films too. The same options give the same bits. The volumes add up to 1. Throws
/// InputError for options out of range.
///
/// Cells by Voro++ (Rycroft 2009, "VORO++: a three-dimensional Voronoi cell library in C++").
SurfaceMesh voronoi_foam(const VoronoiFoamOptions& options);

}  // namespace lostopos
