#include "MultiTracker/run/metrics.h"

#include <set>
#include <utility>

#include "LosTopos/mesh/air_side.h"
#include "LosTopos/topology/region_parts.h"

namespace multitracker {

using lostopos::Region;
using lostopos::SurfaceMesh;
using lostopos::TopologyOperation;

Metrics measure(const SurfaceMesh& mesh, const lostopos::TrackerStep& step,
                const std::vector<lostopos::RegionVolume>& start_volumes) {
  Metrics m;
  m.vertices = mesh.vertex_count();
  m.triangles = mesh.triangle_count();
  m.regions = lostopos::regions(mesh).size();
  const lostopos::AreaBySide areas = lostopos::area_by_side(mesh);
  m.area = areas.air_side + areas.shared;
  m.shared_area = areas.shared;
  m.air_area = areas.air_side;
  m.junction_edges = lostopos::junction_edge_count(mesh);
  const lostopos::RegionShape air = lostopos::region_shape(mesh, lostopos::air);
  m.air_pockets = air.pockets;
  m.air_tunnels = air.tunnels;
  m.volume_drift_max =
      start_volumes.empty() ? 0 : lostopos::largest_volume_drift(lostopos::region_volumes(mesh), start_volumes);
  m.motion_fraction = step.move.fraction;
  m.snaps = step.topology[TopologyOperation::snap].done;
  m.edge_merges = step.topology[TopologyOperation::edge_merge].done;
  m.separations = step.topology[TopologyOperation::separation].done;
  m.region_collapses = step.topology[TopologyOperation::region_collapse].done;
  m.incomplete_vertices = step.topology.incomplete_vertices;
  m.move_seconds = step.move_seconds;
  m.topology_seconds = step.topology_seconds;
  m.remesh_seconds = step.remesh_seconds;
  return m;
}

std::vector<RegionState> region_states(const SurfaceMesh& mesh) {
  std::set<std::pair<Region, Region>> pairs;  // both ways round
  for (lostopos::Triangle t : mesh.triangles()) {
    const auto [p, q] = mesh.labels(t);
    pairs.insert({p, q});
    pairs.insert({q, p});
  }
  std::vector<RegionState> states;
  for (const auto& [region, volume] : lostopos::closed_region_volumes(mesh)) {
    if (region == lostopos::air) continue;
    RegionState state{region, volume};
    for (auto it = pairs.lower_bound({region, Region(0)}); it != pairs.end() && it->first == region; ++it) {
      if (it->second == lostopos::air)
        state.touches_air = true;
      else
        ++state.faces;
    }
    states.push_back(state);
  }
  return states;
}

}  // namespace multitracker
