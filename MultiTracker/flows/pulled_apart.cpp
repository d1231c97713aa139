#include "MultiTracker/flows/pulled_apart.h"

#include <cmath>

namespace multitracker {

std::vector<lostopos::Vec3> PulledApartFlow::predicted(const FlowStep& step) const {
  auto ends = flow_->predicted(step);
  for (lostopos::Vertex v : step.mesh.vertices())
    if (lostopos::is_held(step.held[v.index()]))
      ends[v.index()].x() += std::copysign(speed_ * step.dt, step.mesh.position(v).x());
  return ends;
}

bool PulledApartFlow::still_moves(const FlowStep& now, lostopos::Vertex v) const {
  return lostopos::is_held(now.held[v.index()]) || flow_->still_moves(now, v);
}

}  // namespace multitracker
