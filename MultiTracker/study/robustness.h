#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "MultiTracker/study/robustness_table.h"

namespace multitracker {

/// Spheres grow into a foam (scene normal-flow), many times over: of different numbers, with different seeds, and with
/// steps of different length over the same way.
struct RobustnessOptions {
  std::vector<long> spheres = {8, 27, 64, 125};
  std::vector<double> steps = {0.05, 0.2, 0.5, 1};  ///< in mean edges L, rounded so that whole steps make up the motion
  long seeds = 10;                                  ///< seeds 1 to this
  double total_motion = 5.5;                        ///< along the normal, in L; with `until_closed` the most there is
  /// A run ends as soon as the spheres fill what they enclose, and only that is a success.
  bool until_closed = false;
  std::string layout = "grid";
  std::vector<std::string> assignments;  ///< key=value, for the scene
  bool audit_every_step = false;         ///< as well as at the end
  double time_limit = 600;               ///< of a run, s wall from where it goes on; one that takes longer has failed
  int workers = 1;                       ///< runs at a time, > 0
  /// Where rows and checkpoints are kept, so that the study goes on where it was stopped; empty: nowhere.
  std::filesystem::path folder = {};
};

struct RobustnessHooks {
  /// After every run that is done now.
  std::function<void(const RobustnessRun&, double fraction)> done;
  std::function<bool()> interrupted;
};

/// Throws base::InputError for options that make no sense.
void check(const RobustnessOptions& options);

/// All runs, ordered by spheres, step and seed as the options list them; those that the folder has rows of are not
/// repeated, one that was stopped goes on from its checkpoint. When interrupted it ends early with the runs done so
/// far; those that go on are asked to save and end. Throws as `check`, before the first run, and for a folder that
/// holds a study of other settings or one at work; base::FileError, base::DiskError where the folder cannot be written.
std::vector<RobustnessRun> run_robustness(const RobustnessOptions& options, const RobustnessHooks& hooks = {});

}  // namespace multitracker
