#pragma once

#include <memory>

#include "MultiTracker/flows/surface_flow.h"

namespace multitracker {

/// A flow of which everything that is wholly held goes along x at a steady speed: away from the plane x = 0 on both
/// sides, like two rings pulled apart.
class PulledApartFlow final : public SurfaceFlow {
 public:
  /// `speed`: of either side, L/T.
  PulledApartFlow(std::unique_ptr<SurfaceFlow> flow, double speed) : flow_(std::move(flow)), speed_(speed) {}
  std::vector<lostopos::Vec3> predicted(const FlowStep& step) const override;
  bool still_moves(const FlowStep& now, lostopos::Vertex v) const override;

 private:
  std::unique_ptr<SurfaceFlow> flow_;
  double speed_;
};

}  // namespace multitracker
