#pragma once

#include "Base/io/file_lock.h"
#include "Base/process/child_process.h"
#include "FoamSim/sweep/run_state.h"
#include "FoamSim/sweep/sweep_folder.h"

namespace foamsim::sweep {

/// How runs are started.
struct Launcher {
  std::filesystem::path program;  ///< whose command `run` makes them
  int threads = 1;                ///< of each; 0: all cores
  bool own_group = true;          ///< out of reach of the terminal's Ctrl-C
  bool retry = false;             ///< runs that have failed, too
};

/// Whether a run in this state is to be started.
bool wants_start(const RunState& state, bool retry);

/// A run of a sweep that goes on in a process of its own, which holds the lock of the run's folder. The destructor ends
/// it (SIGTERM) and waits.
class StartedRun {
 public:
  /// Starts the run, or goes on from its checkpoint where it was interrupted or crashed; what both streams say goes to
  /// log.txt. Nothing where another process works in the folder, or there is nothing left to do. Throws
  /// base::FileError.
  static std::optional<StartedRun> start(const Sweep& sweep, std::size_t run, const Launcher& launcher);

  /// How it ended, which is recorded then; nothing while it goes on.
  std::optional<RunState> end();
  /// Asks it to save and end.
  void stop() const;

 private:
  StartedRun(std::filesystem::path folder, std::string program, base::FileLock lock, base::ChildProcess process,
             std::uintmax_t log_begin);
  std::string last_words() const;

  std::filesystem::path folder_;
  std::string program_;  // as it calls itself in its messages
  std::optional<base::FileLock> lock_;
  base::ChildProcess process_;
  std::uintmax_t log_begin_;  // where the log of this attempt begins, bytes
};

}  // namespace foamsim::sweep
