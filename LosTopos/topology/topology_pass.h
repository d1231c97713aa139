#pragma once

#include <utility>
#include <vector>

#include "LosTopos/topology/near_pairs.h"
#include "LosTopos/topology/place_merge.h"
#include "LosTopos/topology/topology_options.h"
#include "LosTopos/topology/topology_statistics.h"
#include "LosTopos/topology/vertex_separation.h"

namespace lostopos {

/// The stages of one topology pass, in the order in which they are meant to be run. Each looks over the whole mesh
/// once, and then at most max_sweeps − 1 times at what its own operations have made.
class TopologyPass {
 public:
  /// `flow`: see VertexSeparation. `context` must be that of no other pass at the same time.
  TopologyPass(RemeshContext& context, const TopologyOptions& options, VertexSeparation::Flow flow,
               TopologyStatistics& statistics);

  void collapse_small_regions();  ///< parts of regions that fit into a small box vanish
  void merge_short_edges();       ///< shortest first; those that an edge collapse must leave, because films would meet
  void snap_near_places();        ///< nearest first
  void separate_vertices();       ///< in order of handles; both results are looked at again
  /// Counts the vertices where regions meet without a common film, and what kept each from being separated.
  void count_what_is_left();

 private:
  void note(TopologyOperation kind, std::vector<Region> regions, const Vec3& position);
  bool can_last(const Site& a, const Site& b) const;
  std::optional<Refusal> snap(const NearPair& near);
  bool collapse_region(Region region, std::vector<Triangle> boundary);
  std::vector<Region> regions_at(const Site& a, const Site& b) const;
  void list_result_star(std::vector<Triangle>& list) const;

  RemeshContext& c_;
  const TopologyOptions& options_;
  TopologyStatistics& statistics_;
  PlaceMerge merge_;
  VertexSeparation separation_;
  double merge_distance_;                  // L
  std::optional<std::size_t> incomplete_;  // vertices, where they have been counted and nothing has changed since
  std::vector<std::pair<Vertex, Refusal>> refused_;  // separations, in their order
};

}  // namespace lostopos
