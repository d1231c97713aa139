#include "MultiTracker/flows/alternating_flow.h"

#include <cmath>

namespace multitracker {

const SurfaceFlow& AlternatingFlow::flow_of(const FlowStep& step) const {
  const double turn = std::floor((step.time + step.dt / 2) / duration_);
  const auto which = static_cast<std::size_t>(std::fmod(turn, static_cast<double>(flows_.size())));
  return *flows_[which];
}

std::vector<lostopos::Vec3> AlternatingFlow::predicted(const FlowStep& step) const {
  return flow_of(step).predicted(step);
}

bool AlternatingFlow::still_moves(const FlowStep& now, lostopos::Vertex v) const {
  return flow_of(now).still_moves(now, v);
}

}  // namespace multitracker
