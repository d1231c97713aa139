#pragma once

#include <cstddef>

#include "Base/interruption.h"

namespace lostopos {

/// What a remeshing pass aims at and what it must not do. Lengths are relative to `target_edge` (h̄), areas to its
/// square, volumes to its cube; angles are in degrees. So a scaled mesh with a scaled target is remeshed alike.
struct RemeshOptions {
  double target_edge = 0;  ///< h̄, L, > 0

  double shortest_edge = 0.5;        ///< shorter edges are collapsed
  double longest_edge = 1.5;         ///< longer edges are split
  double min_area = 0.02;            ///< no operation makes a triangle smaller than this
  double min_angle = 3;              ///< nor one with a smaller angle
  double max_angle = 177;            ///< nor one with a larger angle
  double max_volume_change = 1e-2;   ///< no operation changes a region's volume by more
  double split_angle = 160;          ///< the edge opposite to a larger angle is split
  double smooth_below_angle = 30;    ///< vertices of triangles with a smaller angle are smoothed; 60: all vertices
  double smoothing_tolerance = 0.1;  ///< eigenvalues of the normal quadric below this share of the largest: null space

  bool split = true;
  bool collapse = true;
  bool collapse_to_held = true;  ///< also edges with one held end, to which the other goes; false: never these
  bool flip = true;
  bool smoothing = true;
  /// New vertices go to the modified-butterfly position on films and to the cubic through four vertices on junction
  /// curves, where the neighbourhood and the bounds (that of the volume change above all) allow it; else to the
  /// midpoint. Off by default, for midpoints change no volume and smooth positions on a convex surface add to it.
  bool use_butterfly = false;

  /// How often a pass looks again at what its own operations have made, for each kind of operation.
  int max_sweeps = 10;
  /// Rounds with relaxed bounds while triangles are out of bounds.
  int max_aggressive_rounds = 3;

  std::size_t most_triangles = 0;  ///< a pass that would make more throws base::Error, with the figure; 0: no bound
  base::Interruption interruption = {};  ///< asked before every operation
};

}  // namespace lostopos
