#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "FoamSim/app/commands.h"
#include "FoamSim/sweep/local_sweep.h"

namespace foamsim::app {

/// The program itself, by a path that leads to it from any folder.
std::filesystem::path own_path(const Program& program);

/// Throws base::InputError for a number of --workers that makes no sense.
void require_workers(std::optional<long> workers);

std::size_t count_of(const std::vector<sweep::RunState>& states, sweep::Status status);
/// "3 finished, 1 failed".
std::string counts_text(const std::vector<sweep::RunState>& states);
/// 0 when all have finished; else what docs/output.md says.
int exit_code_for(const std::vector<sweep::RunState>& states);

/// "NAME: failed: MESSAGE" on standard output.
void print_state(const sweep::Sweep& sweep, std::size_t run, const sweep::RunState& state);

/// The runs that are not done, and with `retry` those that failed, too.
std::vector<std::size_t> runs_to_make(const std::vector<sweep::RunState>& states, bool retry);

/// The state of every run; those that a queue has are asked for. Throws base::Error where it does not answer.
std::vector<sweep::RunState> states_with_queue(sweep::Sweep& sweep);

struct SweepSettings {
  sweep::Launcher launcher;
  std::optional<long> workers;                      ///< none: what the cores have room for
  std::string label;                                ///< of the progress bar
  bool quiet = false;                               ///< no progress bar
  std::function<void(std::size_t run)> ended = {};  ///< prints what is to be said of a run that has ended
};

/// Makes what is left of a sweep here, shows how far it is, and keeps its table and `states` up to date; an
/// interruption ends it. Throws base::InputError where the runs are in a queue.
void make_runs(sweep::Sweep& sweep, const SweepSettings& settings, std::vector<sweep::RunState>& states);

}  // namespace foamsim::app
