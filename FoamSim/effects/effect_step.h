#pragma once

#include <span>

#include "FoamSim/sheet/surface_geometry.h"
#include "LosTopos/mesh/hold.h"

namespace foamsim {

/// What effects and constraints see of the step that is being made.
struct EffectStep {
  const lostopos::SurfaceMesh& mesh;
  const SurfaceGeometry& geometry;            ///< of the mesh's present positions
  double time;                                ///< at the start of the step, T
  double dt;                                  ///< T
  std::span<const lostopos::Hold> held = {};  ///< by vertex slot, what a wire or frame holds; empty: nothing
  std::span<const std::uint8_t> solid = {};   ///< by triangle slot, not zero for those of a solid; empty: none

  /// Whether all of v is held.
  bool is_held(lostopos::Vertex v) const { return v.index() < held.size() && lostopos::is_held(held[v.index()]); }
};

/// A stage of an integrator: the instant within the step, and where vertices are then.
struct Stage {
  const EffectStep& step;
  double time;                                ///< T
  std::span<const lostopos::Vec3> positions;  ///< L, one a vertex slot
};

}  // namespace foamsim
