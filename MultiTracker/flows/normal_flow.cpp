#include "MultiTracker/flows/normal_flow.h"

#include "LosTopos/mesh/air_side.h"

namespace multitracker {

std::vector<lostopos::Vec3> NormalFlow::predicted(const FlowStep& step) const {
  std::vector<lostopos::Vec3> ends(step.mesh.positions().begin(), step.mesh.positions().end());
  for (lostopos::Vertex v : step.mesh.vertices())
    ends[v.index()] +=
        step.dt * speed_ * lostopos::free_part(step.held[v.index()], lostopos::air_side_normal(step.mesh, v));
  return ends;
}

bool NormalFlow::still_moves(const FlowStep& now, lostopos::Vertex v) const {
  return lostopos::touches_air(now.mesh, v);
}

}  // namespace multitracker
