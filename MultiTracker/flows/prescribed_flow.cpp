#include "MultiTracker/flows/prescribed_flow.h"

#include "MultiTracker/flows/advect.h"

namespace multitracker {

std::vector<lostopos::Vec3> PrescribedFlow::predicted(const FlowStep& step) const {
  auto positions = carried(*flow_, step.mesh.positions(), step.time, step.dt);
  for (lostopos::Vertex v : step.mesh.vertices()) {
    const lostopos::Hold hold = step.held[v.index()];
    if (hold == lostopos::Hold::none) continue;
    const lostopos::Vec3& start = step.mesh.position(v);
    positions[v.index()] = start + lostopos::free_part(hold, positions[v.index()] - start);
  }
  return positions;
}

}  // namespace multitracker
