#pragma once

#include <string_view>

#include "FoamSim/sheet/circulation.h"
#include "FoamSim/sheet/surface_geometry.h"

namespace foamsim {

/// What an effect sees of the step that is being made.
struct EffectStep {
  const lostopos::SurfaceMesh& mesh;
  const SurfaceGeometry& geometry;  ///< of the mesh's present positions
  double time;                      ///< at the start of the step, T
  double dt;                        ///< T
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
  virtual void update_circulation(const EffectStep& step, CirculationField& circulation) = 0;
  /// Potential energy over air density (L⁵/T²) that it has given to the surface as it is now.
  virtual double potential_energy(const SurfaceGeometry& /*geometry*/) const { return 0.0; }
};

}  // namespace foamsim
