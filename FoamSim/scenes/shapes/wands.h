#pragma once

#include "FoamSim/scenes/shapes/revolution.h"

namespace foamsim {

/// The mouth of a straw: a film across a rim of radius 1 and, behind it, a solid cone that closes the region.
struct StrawShape {
  long segments;     ///< of the rim, ≥ 3
  double mouth = 0;  ///< where the film is on the axis; the cone's tip is 1 before it, L
  Axis axis = Axis::x;
  lostopos::Region inside{1};
};
/// Its held vertices: the rim, then the tip. The film is a fan about a free centre, (inside, air) along the axis.
Ring add_straw(lostopos::SurfaceMesh& mesh, const StrawShape& shape);

/// A straw of n ≥ 3 segments alone, about x: a wand with a film across it. Rim and tip are held.
lostopos::SurfaceMesh wand(long n);

/// Rings of n ≥ 3 vertices and radius 0.5 at x = −0.15, 0, 0.15 about x, a film in the two strips between them, and
/// solid cones from the outer rings to tips at x = ∓1.15, which close region 1. Outer rings and tips are held.
lostopos::SurfaceMesh two_rings(long n);

/// `rings` ≥ 2 rings of n ≥ 3 vertices and radius 1 about y, from y = −½ to ½: an open barrel, nothing held, region 1
/// inside.
lostopos::SurfaceMesh barrel(long n, long rings);

}  // namespace foamsim
