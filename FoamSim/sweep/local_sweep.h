#pragma once

#include <functional>

#include "FoamSim/sweep/started_run.h"

namespace foamsim::sweep {

struct LocalSettings {
  Launcher launcher;
  int workers = 1;              ///< runs at a time, > 0
  bool pass_on_signals = true;  ///< whether an interruption is passed on to the runs: false where all get it anyway
};

/// What the caller hears and may say while runs go on.
struct LocalHooks {
  std::function<void(std::size_t run)> started = {};
  std::function<void(std::size_t run)> ended = {};        ///< its state is in the list by then
  std::function<void(std::size_t running)> waiting = {};  ///< every few milliseconds
  std::function<bool()> interrupted = {};                 ///< asked as often
};

/// The state of every run.
std::vector<RunState> states_of(const Sweep& sweep);

/// Makes those of the runs `todo` that are not done, each in a process of its own, and keeps `states`, one a run of the
/// sweep, up to date. An interruption asks all that go on to save and end, and starts no more. Throws base::FileError
/// where a folder cannot be written; nothing goes on then.
void run_locally(const Sweep& sweep, const std::vector<std::size_t>& todo, const LocalSettings& settings,
                 const LocalHooks& hooks, std::vector<RunState>& states);

}  // namespace foamsim::sweep
