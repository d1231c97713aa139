#pragma once

#include <span>
#include <string_view>

#include "FoamSim/sheet/circulation.h"
#include "FoamSim/sheet/surface_geometry.h"
#include "LosTopos/mesh/hold.h"

namespace foamsim {

/// What an effect sees of the step that is being made.
struct EffectStep {
  const lostopos::SurfaceMesh& mesh;
  const SurfaceGeometry& geometry;            ///< of the mesh's present positions
  double time;                                ///< at the start of the step, T
  double dt;                                  ///< T
  std::span<const lostopos::Hold> held = {};  ///< by vertex slot, what a wire or frame holds; empty: nothing

  /// Whether all of v is held.
  bool is_held(lostopos::Vertex v) const { return v.index() < held.size() && lostopos::is_held(held[v.index()]); }
};

/// Something that acts on the sheet: constructed only for a scene that names it, with its own options and state.
class Effect {
 public:
  Effect() = default;
  Effect(const Effect&) = delete;
  Effect& operator=(const Effect&) = delete;
  virtual ~Effect() = default;

  /// Its name in the registry.
  virtual std::string_view name() const = 0;
  /// Changes Γ over step.dt. Called once a step, in the order of the registry, before velocities are evaluated.
  virtual void update_circulation(const EffectStep& /*step*/, CirculationField& /*circulation*/) {}
  /// Changes where vertices go in the step: `predicted` has one position (L) a vertex slot, those that the air's motion
  /// leads to. Called once a step, in the order of the registry, on the surface that update_circulation saw; vertices
  /// that are held stay whatever it says.
  virtual void move_vertices(const EffectStep& /*step*/, std::span<lostopos::Vec3> /*predicted*/) {}
  /// Potential energy over air density (L⁵/T²) that it has given to the surface as it is now.
  virtual double potential_energy(const SurfaceGeometry& /*geometry*/) const { return 0.0; }
};

}  // namespace foamsim
