#pragma once

#include <cstdint>
#include <memory>
#include <nlohmann/json_fwd.hpp>

#include "FoamSim/dynamics/topology_totals.h"
#include "LosTopos/surface_tracker.h"

namespace foamsim {

/// Everything in which a simulation differs from one that has just been made of the same scene: what SurfaceMesh::State
/// is to the mesh. With it a step can be undone and a run be resumed, to the bit.
struct SimulationState {
  long steps = 0;
  double dt = 0;                                 ///< length of a step, T, > 0
  std::int64_t vertex_ids = 0;                   ///< given so far, where vertices are followed; else 0
  TopologyTotals topology;                       ///< counts since the start of the run
  lostopos::SurfaceTracker::State tracker;       ///< the surface with every named attribute, circulation among them
  std::shared_ptr<const nlohmann::json> models;  ///< by kind and name: what effects, constraints and dynamics remember
};

/// For checkpoints; binary arrays inside, so that CBOR is the format to write it in.
nlohmann::json to_json(const SimulationState& state);
/// Throws base::Error for anything but what to_json gives. What models remember they look at themselves, when it is
/// given back to them.
SimulationState simulation_state_from_json(const nlohmann::json& value);

}  // namespace foamsim
