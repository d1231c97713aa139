#pragma once

#include <string>
#include <vector>

#include "FoamSim/run/run.h"

namespace foamsim {

struct ComparedRun {
  std::string area;
  RunOutcome outcome;
  /// How far the area-weighted centre of the films has moved since the start, L.
  double centroid_drift() const;
};

/// Runs the scene once with each area strategy, into `settings.out`/STRATEGY, and writes `settings.out`/compare.csv.
/// Stops early when a run is interrupted. `hooks_for` gives each run its hooks. Throws like run_scene.
std::vector<ComparedRun> compare_areas(const Scene& scene, const std::vector<std::string>& areas,
                                       const RunSettings& settings,
                                       const std::function<RunHooks(const std::string& area)>& hooks_for);

}  // namespace foamsim
