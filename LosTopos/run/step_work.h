#pragma once

#include "Base/timing/stage_times.h"
#include "LosTopos/collision/safe_move.h"
#include "LosTopos/remeshing/remesh_statistics.h"
#include "LosTopos/topology/topology_statistics.h"

namespace lostopos::run {

/// What a step did to the surface and took, or the sum of that over steps.
struct StepWork {
  base::StageTimes times;  ///< wall seconds by stage
  MoveStatistics move;
  TopologyStatistics topology;  ///< of a step: with its events
  RemeshStatistics remesh;

  /// Adds a step; its events are not kept.
  void add(const StepWork& step);
};

}  // namespace lostopos::run
