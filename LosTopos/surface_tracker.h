#pragma once

#include <span>

#include "LosTopos/mesh/surface_mesh.h"

namespace lostopos {

/// Moves a labelled surface to where a simulation predicts it to be: the one class that a simulation talks to.
class SurfaceTracker {
 public:
  explicit SurfaceTracker(SurfaceMesh mesh) : mesh_(std::move(mesh)) {}

  const SurfaceMesh& mesh() const { return mesh_; }
  /// For data that is attached to the mesh (attributes).
  SurfaceMesh& mesh() { return mesh_; }

  /// Moves every living vertex in a straight line to its entry of `predicted` (L, indexed by vertex handle, one per
  /// slot). Throws MotionError, with the mesh as it was, when a prediction is not finite.
  void advance(std::span<const Vec3> predicted);

 private:
  SurfaceMesh mesh_;
};

}  // namespace lostopos
