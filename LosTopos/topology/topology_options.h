#pragma once

namespace lostopos {

/// When a vertex at which two regions meet without a common film is separated.
enum class SeparationRule {
  area,  ///< when the surface's area shrinks: films under tension
  flow,  ///< when the motion of the last step diverges along the direction of separation: prescribed flows
};

/// How films join, part and vanish (docs/method.md "Topology"). Lengths are relative to the target edge h̄.
struct TopologyOptions {
  bool enabled = false;

  bool snap = true;              ///< join surfaces that come close
  bool separate = true;          ///< T1: part regions that meet without a common film
  bool collapse_regions = true;  ///< let regions that are too small vanish

  double merge_distance = 0.1;  ///< surfaces nearer than this are joined (0.02 for plain tracking)
  double merge_edge = 0;        ///< edges shorter than this are merged; 0: half the merge distance
  double pull_apart = 0.1;      ///< distance that a separation opens
  /// A region that fits into a box with this diagonal vanishes; so does a tetrahedron thinner than `merge_distance`.
  double smallest_region = 0.5;
  SeparationRule separation = SeparationRule::area;

  /// How often a pass looks again at what its own operations have made, for each kind of operation.
  int max_sweeps = 5;
  /// A step in which surfaces collide moves vertices at most this far (in h̄) before the topology is looked at again: a
  /// longer motion is done in parts, so that surfaces which are pressed together within a step meet instead of
  /// crumpling.
  double longest_motion = 0.1;
};

}  // namespace lostopos
