#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "Base/options/option_set.h"

namespace multitracker {

/// Spheres grow into a foam (scene normal-flow), many times over: of different numbers, with different seeds, and with
/// steps of different length over the same way.
struct RobustnessOptions {
  std::vector<long> spheres = {8, 27, 64, 125};
  std::vector<double> steps = {0.05, 0.2, 0.5, 1};  ///< in mean edges L, rounded so that whole steps make up the motion
  long seeds = 10;                                  ///< seeds 1 to this
  double total_motion = 5.5;                        ///< along the normal, in L
  std::string layout = "grid";
  std::vector<std::string> assignments;  ///< key=value, for the scene
  bool audit_every_step = false;         ///< as well as at the end
  double time_limit = 600;               ///< of a run, s wall; one that takes longer has failed
};

/// One run, done in a process of its own.
struct RobustnessRun {
  long spheres = 0;
  double step = 0;
  long seed = 0;
  bool success = false;  ///< every step was done, and the audit is clean
  std::string message;   ///< why not
  double shared_area = 0, air_area = 0, cpu_seconds = 0, peak_megabytes = 0;
  long triangles = 0, junction_edges = 0, snaps = 0, separations = 0;
};

/// The runs of one number of spheres with one length of step.
struct RobustnessSummary {
  long spheres = 0;
  double step = 0;
  long runs = 0, successes = 0;
  double shared_area = 0, cpu_seconds = 0;  ///< means over the successes
  double peak_megabytes = 0;                ///< largest
};

struct RobustnessHooks {
  std::function<void(const RobustnessRun&, double fraction)> done;
  std::function<bool()> interrupted;
};

/// Throws base::InputError for options that make no sense.
void check(const RobustnessOptions& options);

/// Throws as `check`, before the first run. Ends early, with the runs done so
/// far, when interrupted.
std::vector<RobustnessRun> run_robustness(const RobustnessOptions& options, const RobustnessHooks& hooks = {});

/// In the order of the runs.
std::vector<RobustnessSummary> summarise(const std::vector<RobustnessRun>& runs);

/// Header and row of a CSV file, a row a run.
std::string robustness_csv_header();
std::string robustness_csv_row(const RobustnessRun& run);

}  // namespace multitracker
