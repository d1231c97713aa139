#pragma once

#include <vector>

#include "LosTopos/mesh/measures.h"
#include "LosTopos/surface_tracker.h"

namespace multitracker {

/// The surface after a step, and what the step did.
struct Metrics {
  long step = 0;
  double time = 0;
  std::size_t vertices = 0, triangles = 0, regions = 0;
  double area = 0;         ///< L²
  double shared_area = 0;  ///< of films between two regions that are not air
  double air_area = 0;     ///< of films that touch the air
  std::size_t junction_edges = 0;
  std::size_t air_pockets = 0;  ///< pieces of the air that films enclose
  double air_tunnels = 0;       ///< through what the air surrounds: see lostopos::RegionShape
  double volume_drift_max = 0;  ///< see lostopos::largest_volume_drift
  double motion_fraction = 1;   ///< of the asked motion that was done
  std::size_t snaps = 0, edge_merges = 0, separations = 0, region_collapses = 0, incomplete_vertices = 0;
  double flow_seconds = 0, move_seconds = 0, topology_seconds = 0, remesh_seconds = 0;  ///< wall time
};

/// `start_volumes`: empty for films that are not closed; the drift is 0 then.
Metrics measure(const lostopos::SurfaceMesh& mesh, const lostopos::TrackerStep& step,
                const std::vector<lostopos::RegionVolume>& start_volumes);

/// One region but the air.
struct RegionState {
  lostopos::Region region;
  double volume = 0;      ///< L³
  std::size_t faces = 0;  ///< other regions but the air that it has a film with
  bool touches_air = false;
};
/// Of all regions with a closed boundary but the air, ascending.
std::vector<RegionState> region_states(const lostopos::SurfaceMesh& mesh);

}  // namespace multitracker
