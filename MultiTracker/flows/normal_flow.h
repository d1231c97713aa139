#pragma once

#include "MultiTracker/flows/surface_flow.h"

namespace multitracker {

/// Growth into the air: vertices with triangles that touch the air move along their area-weighted normal there (see
/// lostopos::air_side_normal) at a given speed; all others stay.
class NormalFlow final : public SurfaceFlow {
 public:
  explicit NormalFlow(double speed) : speed_(speed) {}  ///< L/T
  std::vector<lostopos::Vec3> predicted(const FlowStep& step) const override;
  /// Not where films have met: there is no air left to grow into.
  bool still_moves(const FlowStep& now, lostopos::Vertex v) const override;

 private:
  double speed_;
};

}  // namespace multitracker
