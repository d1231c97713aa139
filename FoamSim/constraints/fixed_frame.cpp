#include "FoamSim/constraints/fixed_frame.h"

#include "LosTopos/mesh/hold.h"

namespace foamsim {

void FixedFrame::attach(lostopos::SurfaceTracker& tracker) {
  for (lostopos::Vertex v : vertices_) tracker.held()[v] = lostopos::Hold::all;
}

void FixedFrame::prescribe(const Stage& stage, std::span<lostopos::Vec3> positions) {
  const auto start = stage.step.mesh.positions();
  for (std::size_t i = 0; i < stage.step.held.size(); ++i)
    for (int k = 0; k < 3; ++k)
      if (lostopos::holds(stage.step.held[i], k)) positions[i][k] = start[i][k];
}

}  // namespace foamsim
