#pragma once

#include <memory>
#include <vector>

#include "MultiTracker/flows/surface_flow.h"

namespace multitracker {

/// Several flows in turn, each for the same time.
class AlternatingFlow final : public SurfaceFlow {
 public:
  /// `duration`: of each turn, T; a step belongs to the flow whose turn it is in the middle of the step.
  AlternatingFlow(std::vector<std::unique_ptr<SurfaceFlow>> flows, double duration)
      : flows_(std::move(flows)), duration_(duration) {}
  std::vector<lostopos::Vec3> predicted(const FlowStep& step) const override;
  bool still_moves(const FlowStep& now, lostopos::Vertex v) const override;

 private:
  const SurfaceFlow& flow_of(const FlowStep& step) const;

  std::vector<std::unique_ptr<SurfaceFlow>> flows_;
  double duration_;
};

}  // namespace multitracker
