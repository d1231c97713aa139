#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "LosTopos/mesh/handles.h"
#include "LosTopos/remeshing/remesh_statistics.h"
#include "LosTopos/vec3.h"

namespace lostopos {

enum class TopologyOperation {
  snap,             ///< two places that are close become one vertex
  edge_merge,       ///< a very short edge goes although that changes how films meet there
  separation,       ///< a vertex parts in two: T1, or the end of a contact at a point
  region_collapse,  ///< a region vanishes
  burst,            ///< a region's films towards the air break; asked for from outside, not an operation of the passes
};
/// Of the passes.
inline constexpr std::size_t topology_operation_count = 4;
/// As in events.csv: "snap", "edge_merge", "separation", "region_collapse", "burst".
const char* name(TopologyOperation operation);

/// Something that changed how regions meet.
struct TopologyEvent {
  TopologyOperation kind = TopologyOperation::snap;
  /// The regions that took part, ascending; of a separation the two that lose contact first, then those between which
  /// films are new.
  std::vector<Region> regions;
  Vec3 position = Vec3::Zero();  ///< L
};

/// What the topology passes of a step did. Sums over passes by +=.
struct TopologyStatistics {
  std::array<OperationCounts, topology_operation_count> operations;
  std::size_t cancelled_triangles = 0;  ///< coincident ones that became one film or vanished
  std::size_t incomplete_vertices = 0;  ///< left by the last pass: two regions meet there without a common film
  /// Of these, by what kept the last attempt from separating them; where none was made they are in no class.
  std::array<std::size_t, refusal_count> incomplete_by_refusal{};
  std::vector<TopologyEvent> events;  ///< in the order in which they happened
  double seconds = 0;                 ///< wall time in all

  OperationCounts& operator[](TopologyOperation o) { return operations[static_cast<std::size_t>(o)]; }
  const OperationCounts& operator[](TopologyOperation o) const { return operations[static_cast<std::size_t>(o)]; }
  std::size_t done_in_all() const;
  TopologyStatistics& operator+=(const TopologyStatistics& other);
};

}  // namespace lostopos
