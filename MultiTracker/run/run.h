#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "LosTopos/run/run.h"
#include "MultiTracker/run/tracking.h"

namespace multitracker {

/// How a run was called for: what its run.json begins with.
struct RunCall {
  std::string version, command;
};

struct RunSettings {
  std::filesystem::path out = {};  ///< empty: nothing is written
  bool force = false;              ///< replace a run that the folder holds
  bool go_on = false;              ///< the tracking comes from the folder's own checkpoint: its tables go on
  bool audit = false;              ///< audit the surface after every step, and stop when it is not clean
  RunCall call = {};
};

/// Asked for and told while a run goes on; may be empty.
struct RunHooks {
  std::function<void(const Metrics&, double fraction)> progress;
  std::function<bool()> interrupted;
  std::function<bool(const Metrics&)> done = {};  ///< asked after every step: whether the run has what it was made for
};

using RunEnd = lostopos::run::End;

struct RunOutcome {
  RunEnd end = RunEnd::finished;
  std::string message;  ///< why it failed
  Metrics start, last;
  lostopos::TopologyStatistics topology;  ///< of all steps, without the events
  lostopos::RemeshStatistics remesh;
  double wall_seconds = 0;
  std::filesystem::path last_frame, checkpoint;  ///< the last good state; empty when nothing is written
};

/// Goes on to `last_step`, counted from the scene's start. A step that cannot be done, or after which the audit finds
/// something, ends the run as failed; what was done until then is kept.
RunOutcome run(Tracking& tracking, long last_step, const RunSettings& settings, const RunHooks& hooks = {});

}  // namespace multitracker
