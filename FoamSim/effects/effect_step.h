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
  /// By vertex slot: not zero for vertices that, as long as they are held, let in the air that is blown: no wire says
  /// how much flows there; empty: none.
  std::span<const std::uint8_t> mouth = {};

  /// Whether all of v is held.
  bool is_held(lostopos::Vertex v) const { return v.index() < held.size() && lostopos::is_held(held[v.index()]); }
  bool is_mouth(lostopos::Vertex v) const { return v.index() < mouth.size() && mouth[v.index()] != 0 && is_held(v); }
};

/// A stage of an integrator: the instant within the step, and where vertices are then.
struct Stage {
  const EffectStep& step;
  double time;                                ///< T
  std::span<const lostopos::Vec3> positions;  ///< L, one a vertex slot
};

}  // namespace foamsim
