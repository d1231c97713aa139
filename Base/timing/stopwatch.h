#pragma once

#include <chrono>
#include <string_view>

#include "Base/timing/stage_times.h"

namespace base {

/// Wall time since it was made or last restarted. The one clock of the project.
class Stopwatch {
 public:
  double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }
  /// The seconds so far; starts again from zero.
  double restart() {
    const Clock::time_point now = Clock::now();
    const double passed = std::chrono::duration<double>(now - start_).count();
    start_ = now;
    return passed;
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

/// Adds the wall time of its own life to a sum (s), or to a stage of some stage times.
class TimedScope {
 public:
  explicit TimedScope(double& seconds) : seconds_(&seconds) {}
  TimedScope(StageTimes& times, std::string_view stage) : times_(&times), stage_(stage) {}
  TimedScope(const TimedScope&) = delete;
  TimedScope& operator=(const TimedScope&) = delete;
  ~TimedScope() {
    if (seconds_ != nullptr)
      *seconds_ += watch_.seconds();
    else
      times_->add(stage_, watch_.seconds());
  }

 private:
  double* seconds_ = nullptr;
  StageTimes* times_ = nullptr;
  std::string_view stage_;
  Stopwatch watch_;
};

}  // namespace base
