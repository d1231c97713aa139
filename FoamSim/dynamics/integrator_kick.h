#pragma once

#include <functional>
#include <span>

#include "FoamSim/effects/effect_step.h"
#include "FoamSim/sheet/sheet_strength.h"

namespace foamsim {

/// What an integrator has to know to change Γ by the films' tension itself.
struct CirculationKick {
  const EffectStep& step;
  CirculationField& circulation;
  double sigma;  ///< tension of one film side over density, L³/T²
  double delta;  ///< δ, L
  /// Velocities (L/T, by vertex slot) that a sheet with the vertices at the start of the step induces there.
  std::function<void(std::span<const SheetTriangle> sheet, std::span<lostopos::Vec3> velocity)> velocity;
};

}  // namespace foamsim
