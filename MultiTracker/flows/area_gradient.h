#pragma once

#include "MultiTracker/flows/surface_flow.h"

namespace multitracker {

/// Films under tension by the gradient of their area as it is, v = −2 ∂A/∂x_v: not divided by a vertex' area as mean
/// curvature flow is (see mean_curvature.h), so that a speed is a length over a time without a scale of its own, and a
/// film of edges h long moves 3 / (2 A_v) times as slowly as by its curvature.
///
/// A step is done in substeps in which no edge shortens by more than 80%, 100 at most; in the last of these a vertex
/// goes no farther than 0.4 of its shortest edge.
class AreaGradientFlow final : public SurfaceFlow {
 public:
  std::vector<lostopos::Vec3> predicted(const FlowStep& step) const override;
};

}  // namespace multitracker
