#include "LosTopos/topology/topology_statistics.h"

namespace lostopos {

const char* name(TopologyOperation operation) {
  switch (operation) {
    case TopologyOperation::snap:
      return "snap";
    case TopologyOperation::edge_merge:
      return "edge_merge";
    case TopologyOperation::separation:
      return "separation";
    case TopologyOperation::region_collapse:
      return "region_collapse";
    case TopologyOperation::burst:
      return "burst";
  }
  return "unknown operation";
}

std::size_t TopologyStatistics::done_in_all() const {
  std::size_t done = 0;
  for (const OperationCounts& counts : operations) done += counts.done;
  return done;
}

TopologyStatistics& TopologyStatistics::operator+=(const TopologyStatistics& other) {
  for (std::size_t i = 0; i < operations.size(); ++i) operations[i] += other.operations[i];
  cancelled_triangles += other.cancelled_triangles;
  incomplete_vertices = other.incomplete_vertices;
  incomplete_by_refusal = other.incomplete_by_refusal;
  events.insert(events.end(), other.events.begin(), other.events.end());
  seconds += other.seconds;
  return *this;
}

}  // namespace lostopos
