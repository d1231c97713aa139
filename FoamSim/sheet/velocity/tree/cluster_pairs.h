#pragma once

#include <cstdint>
#include <vector>

#include "FoamSim/sheet/velocity/tree/cluster_tree.h"

namespace foamsim {

/// By target cluster: the source clusters that it meets as a whole, far away, and, for leaves, those whose points it
/// meets one by one. Every pair of points is in exactly one pair of clusters. With the same tree on both sides the
/// pairs are mutual.
struct ClusterPairs {
  std::vector<std::vector<std::uint32_t>> far, near;

  /// Far: the balls' radii are no more than `openness` (0 to 1) of their middles' distance.
  ClusterPairs(const ClusterTree& targets, const ClusterTree& sources, double openness);
};

}  // namespace foamsim
