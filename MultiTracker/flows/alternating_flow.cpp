#include "MultiTracker/flows/alternating_flow.h"

#include <cmath>

namespace multitracker {

std::vector<lostopos::Vec3> AlternatingFlow::predicted(const FlowStep& step) const {
  const double turn = std::floor((step.time + step.dt / 2) / duration_);
  const auto which = static_cast<std::size_t>(std::fmod(turn, static_cast<double>(flows_.size())));
  return flows_[which]->predicted(step);
}

}  // namespace multitracker
