#pragma once

#include "MultiTracker/flows/surface_flow.h"

namespace multitracker {

/// Mean curvature flow of all films, of unit tension: every vertex moves against the gradient of the total area over a
/// third of the area of its triangles, v = −∇A / A_v (the cotangent discretisation of 2H n on a smooth film, Pinkall
/// and Polthier 1993; at Plateau borders it drives the films to 120°). Speed L/T where the tension is 1 L²/T.
///
/// Explicit steps are stable for dt ≤ A_v / Σ|w| at every vertex, w the cotangent weights of its edges. A step is done
/// in substeps of half the dt that is stable at nine vertices of ten, 64 at most. A vertex whose triangles are badly
/// shaped or tiny moves with the largest dt that is stable at itself, and none farther in a substep than half the least
/// height of its triangles.
class MeanCurvatureFlow final : public SurfaceFlow {
 public:
  explicit MeanCurvatureFlow(double mobility = 1) : mobility_(mobility) {}  ///< factor of the speed
  std::vector<lostopos::Vec3> predicted(const FlowStep& step) const override;

 private:
  double mobility_;
};

}  // namespace multitracker
