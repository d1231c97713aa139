#pragma once

#include "LosTopos/topology/topology_statistics.h"

namespace foamsim {

/// How often the topology has changed since the start of a run.
struct TopologyTotals {
  std::size_t snaps = 0;
  std::size_t edge_merges = 0;
  std::size_t separations = 0;  ///< T1s
  std::size_t region_collapses = 0;
  std::size_t cancelled_triangles = 0;

  void add(const lostopos::TopologyStatistics& step) {
    using lostopos::TopologyOperation;
    snaps += step[TopologyOperation::snap].done;
    edge_merges += step[TopologyOperation::edge_merge].done;
    separations += step[TopologyOperation::separation].done;
    region_collapses += step[TopologyOperation::region_collapse].done;
    cancelled_triangles += step.cancelled_triangles;
  }
};

}  // namespace foamsim
