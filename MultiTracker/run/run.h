#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "MultiTracker/run/tracking.h"

namespace multitracker {

struct RunSettings {
  std::filesystem::path out;  ///< empty: nothing is written
  bool force = false;         ///< replace a run that the folder holds
  bool audit = false;         ///< audit the surface after every step, and stop when it is not clean
};

/// Asked for and told while a run goes on; may be empty.
struct RunHooks {
  std::function<void(const Metrics&, double fraction)> progress;
  std::function<bool()> interrupted;
};

enum class RunEnd { finished, interrupted, failed };
/// "finished", "interrupted", "failed".
const char* name(RunEnd end);

struct RunOutcome {
  RunEnd end = RunEnd::finished;
  std::string message;  ///< why it failed
  Metrics start, last;
  lostopos::TopologyStatistics topology;  ///< of all steps, without the events
  lostopos::RemeshStatistics remesh;
  double wall_seconds = 0;
  std::filesystem::path last_frame;  ///< the last good state; empty when nothing is written
};

/// Does `steps` steps of a scene that is at its start. A step that cannot be done, or after which the audit finds
/// something, ends the run as failed; what was done until then is kept.
RunOutcome run(Tracking& tracking, long steps, long frame_every, const RunSettings& settings,
               const RunHooks& hooks = {});

}  // namespace multitracker
