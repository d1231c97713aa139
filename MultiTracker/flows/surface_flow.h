#pragma once

#include <span>
#include <vector>

#include "LosTopos/mesh/hold.h"
#include "LosTopos/mesh/surface_mesh.h"

namespace multitracker {

/// The surface at the start of a step, and the step.
struct FlowStep {
  const lostopos::SurfaceMesh& mesh;
  std::span<const lostopos::Hold> held;  ///< see lostopos/mesh/hold.h; one per vertex slot
  double time, dt;                       ///< T
};

/// What moves a surface. Prescribed velocity fields and motions that depend on the surface itself (growth along its
/// normals, mean curvature) look the same to a run.
class SurfaceFlow {
 public:
  SurfaceFlow() = default;
  SurfaceFlow(const SurfaceFlow&) = delete;
  SurfaceFlow& operator=(const SurfaceFlow&) = delete;
  virtual ~SurfaceFlow() = default;

  /// Where every vertex is to be at the end of the step (L), one entry per vertex slot. Held coordinates stay, unless
  /// the flow is one that moves what is held.
  virtual std::vector<lostopos::Vec3> predicted(const FlowStep& step) const = 0;

  /// Whether a vertex still follows its prediction when the surface has changed around it within the step, to be as
  /// `now` says (of `now`, only mesh and held are of another moment than the step's start).
  virtual bool still_moves(const FlowStep& /*now*/, lostopos::Vertex) const { return true; }
};

}  // namespace multitracker
