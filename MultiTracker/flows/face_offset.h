#pragma once

#include "MultiTracker/flows/pair_speeds.h"
#include "MultiTracker/flows/surface_flow.h"

namespace multitracker {

/// Motion of every film along its normal by face offsetting (Jiao 2007, "Face offsetting: a unified approach for
/// explicit moving interfaces"): every triangle's plane moves by its speed, and a vertex goes to where the planes
/// around it meet in the least-squares sense, Σ area (n · d − speed dt)² → min, in the directions that the planes
/// determine (eigenvalues of Σ area n nᵀ above 0.3% of the largest) and not at all in the others.
///
/// Entropy solution: where planes run into each other (a concave corner that grows) their meeting point is the
/// solution. Where they run apart (a convex corner that grows) it is the circle of Huygens' waves that a corner sends
/// out, and the vertex moves no farther than the fastest film.
class FaceOffsetFlow final : public SurfaceFlow {
 public:
  explicit FaceOffsetFlow(PairSpeeds speeds) : speeds_(std::move(speeds)) {}
  std::vector<lostopos::Vec3> predicted(const FlowStep& step) const override;

 private:
  lostopos::Vec3 displacement(const FlowStep& step, lostopos::Vertex v) const;

  PairSpeeds speeds_;
};

}  // namespace multitracker
