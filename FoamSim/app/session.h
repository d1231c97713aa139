#pragma once

#include <tbb/global_control.h>

#include <chrono>
#include <optional>
#include <string>

#include "FoamSim/run/run.h"

namespace foamsim::app {

/// Limits the threads of everything that follows, while it lives; 0: no limit.
class ThreadLimit {
 public:
  explicit ThreadLimit(int threads) {
    if (threads > 0) limit_.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  }

 private:
  std::optional<tbb::global_control> limit_;
};

/// Turns Ctrl-C (SIGINT) and SIGTERM into a question that a run asks after every step, while it lives; a second signal
/// ends the program at once.
class InterruptGuard {
 public:
  InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;
  ~InterruptGuard();
  static bool interrupted();
};

/// Shows how far a run is: a bar on a terminal, a line every few seconds elsewhere, nothing when quiet.
class Progress {
 public:
  Progress(std::string label, bool quiet);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();
  void show(const Metrics& metrics, double fraction);
  /// Another label, the same clock.
  void relabel(std::string label) { label_ = std::move(label); }
  /// Takes the bar off the terminal, so that a line can be printed.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;
  std::string label_;
  bool quiet_, terminal_, drawn_ = false;
  Clock::time_point start_, last_;
};

/// Hooks that show progress and ask for interruption.
RunHooks hooks_for(Progress& progress);

}  // namespace foamsim::app
