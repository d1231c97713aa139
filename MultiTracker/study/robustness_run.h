#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "Base/options/option_set.h"
#include "MultiTracker/study/child_process.h"
#include "MultiTracker/study/robustness_table.h"

namespace multitracker {

/// How a run of the study is made.
struct RobustnessTask {
  RobustnessKey key;
  base::OptionSet options;  ///< of scene normal-flow
  bool until_closed = false, audit_every_step = false;
  std::filesystem::path folder;  ///< of its own, for its checkpoint; empty: none
};

/// Makes a run, or goes on with it, in a process made for it, and returns what `read_result` reads. A run that is told
/// to stop saves its checkpoint.
std::string make_robustness_run(const RobustnessTask& task, const std::function<bool()>& stop);

/// Of how the process ended; nothing when the run was stopped, and can go on.
std::optional<RobustnessRun> read_result(const RobustnessTask& task, const ChildResult& child);

}  // namespace multitracker
