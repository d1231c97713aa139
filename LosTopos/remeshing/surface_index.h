#pragma once

#include <vector>

#include "LosTopos/collision/broad_phase.h"

namespace lostopos {

/// The mesh's triangles by place. It is built when first asked, so that a pass that changes nothing does not pay for
/// it, and follows every edit from then on. A triangle's box contains the triangle.
class SurfaceIndex {
 public:
  /// `given`: a broad phase that already holds every living triangle with a box that contains it, to be used and kept
  /// up to date; or null.
  SurfaceIndex(const SurfaceMesh& mesh, BroadPhase* given) : mesh_(mesh), used_(given) {}

  /// The triangles whose boxes overlap `box`, sorted, in `found` (cleared first).
  void nearby(const Box& box, std::vector<Triangle>& found);
  /// To be called after a triangle was added or its corners moved.
  void changed(Triangle t);
  /// To be called when a triangle is removed.
  void removed(Triangle t);

 private:
  const SurfaceMesh& mesh_;
  BroadPhase own_;
  BroadPhase* used_;
};

}  // namespace lostopos
