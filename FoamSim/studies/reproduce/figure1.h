#pragma once

#include <functional>
#include <string>
#include <vector>

#include "FoamSim/run/compare.h"

namespace foamsim {

/// The report's figure 1: one double bubble, without damping, under the three strategies.
struct Figure1Options {
  /// The resolution at which all three behave as published: `naive` drifts away by a bubble's radius, `constant-edge`
  /// (φ = 0.75) comes to about 135°, `averaged` to about 125°. Coarser: see docs/accuracy.md.
  long n = 48;
  double time = 20;  ///< T
  long frames = 4;   ///< pictures a strategy after the start, evenly spaced in time
};

/// Runs them into `out`/STRATEGY and writes `out`/compare.csv, as compare_areas does.
std::vector<ComparedRun> run_figure1(const Figure1Options& options, const RunSettings& settings,
                                     const std::function<RunHooks(const std::string& area)>& hooks_for);

/// How many times as far as `area`'s the centroid of `naive` has drifted. Throws base::InputError
/// when one of the two is not among the rows.
double drift_ratio(const std::vector<ComparisonRow>& rows, const std::string& area);

}  // namespace foamsim
