#pragma once

#include <chrono>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace base {

/// Wall seconds spent in named stages, in the order in which the stages first ran.
class StageTimes {
 public:
  void add(std::string_view stage, double seconds);
  void add(const StageTimes& other);
  double seconds(std::string_view stage) const;
  double total() const;
  const std::vector<std::pair<std::string, double>>& stages() const { return stages_; }

 private:
  std::vector<std::pair<std::string, double>> stages_;
};

/// Adds the wall time of its own life to a stage.
class StageTimer {
 public:
  StageTimer(StageTimes& times, std::string_view stage) : times_(times), stage_(stage), start_(Clock::now()) {}
  StageTimer(const StageTimer&) = delete;
  StageTimer& operator=(const StageTimer&) = delete;
  ~StageTimer() { times_.add(stage_, std::chrono::duration<double>(Clock::now() - start_).count()); }

 private:
  using Clock = std::chrono::steady_clock;
  StageTimes& times_;
  std::string_view stage_;
  Clock::time_point start_;
};

}  // namespace base
