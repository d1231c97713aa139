#pragma once

#include <cstdint>
#include <vector>

#include "FoamSim/sheet/velocity/tree/cluster_tree.h"
#include "FoamSim/sheet/velocity/tree/pair_orders.h"

namespace foamsim {

/// By target cluster: the source clusters that it meets as a whole, far away, and, for leaves, those whose points it
/// meets one by one. Every pair of points is in exactly one pair of clusters. With the same tree on both sides the
/// pairs are mutual.
struct ClusterPairs {
  struct Far {
    std::uint32_t source;
    std::uint32_t order;  ///< of the grids, as PairOrders counts them
  };
  std::vector<std::vector<Far>> far;
  std::vector<std::vector<std::uint32_t>> near;

  /// Far: the balls' radii are no more than most_open() of their middles' distance.
  ClusterPairs(const ClusterTree& targets, const ClusterTree& sources, const PairOrders& orders);

  /// Leaves meet leaves only, point by point.
  static ClusterPairs of_leaves(const ClusterTree& targets, const ClusterTree& sources);

  /// What it costs to meet so, in pairs of points: by count, so that it is the same for the same places.
  double cost(const ClusterTree& targets, const ClusterTree& sources, const PairOrders& orders) const;

 private:
  explicit ClusterPairs(std::size_t targets) : far(targets), near(targets) {}
};

}  // namespace foamsim
