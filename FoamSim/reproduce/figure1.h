#pragma once

#include <functional>
#include <string>
#include <vector>

#include "FoamSim/run/compare.h"

namespace foamsim {

/// The report's figure 1: one double bubble, without damping, under the three strategies.
struct Figure1Options {
  /// Coarse, because `naive` loses its balance the sooner the coarser the mesh is; published behaviour at this size:
  /// `naive` drifts by about a bubble's radius, `constant-edge` (φ = 0.75) rests at about 163°, `averaged` at 137°.
  long n = 16;
  double time = 30;  ///< T
  long frames = 4;   ///< pictures a strategy after the start, evenly spaced in time
};

/// Runs them into `out`/STRATEGY and writes `out`/compare.csv, as compare_areas does.
std::vector<ComparedRun> run_figure1(const Figure1Options& options, const RunSettings& settings,
                                     const std::function<RunHooks(const std::string& area)>& hooks_for);

/// How many times farther `naive` has drifted than the strategy that drifted farthest of the others.
double drift_ratio(const std::vector<ComparisonRow>& rows);

}  // namespace foamsim
