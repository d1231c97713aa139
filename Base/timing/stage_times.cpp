#include "Base/timing/stage_times.h"

#include <algorithm>

namespace base {

void StageTimes::add(std::string_view stage, double seconds) {
  const auto it = std::ranges::find(stages_, stage, &std::pair<std::string, double>::first);
  if (it == stages_.end())
    stages_.emplace_back(stage, seconds);
  else
    it->second += seconds;
}

void StageTimes::add(const StageTimes& other) {
  for (const auto& [stage, seconds] : other.stages_) add(stage, seconds);
}

double StageTimes::seconds(std::string_view stage) const {
  const auto it = std::ranges::find(stages_, stage, &std::pair<std::string, double>::first);
  return it == stages_.end() ? 0.0 : it->second;
}

double StageTimes::total() const {
  double sum = 0;
  for (const auto& [stage, seconds] : stages_) sum += seconds;
  return sum;
}

}  // namespace base
