#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string_view>

#include "FoamSim/effects/effect_step.h"
#include "FoamSim/sheet/circulation.h"
#include "LosTopos/surface_tracker.h"

namespace foamsim {

/// The velocity (L/T) of the sheet at its own vertices for the circulation as it is now: one entry a vertex slot.
using SheetVelocities = std::function<void(std::span<lostopos::Vec3> velocity)>;

/// Something that holds vertices: it prescribes where they go, whole or coordinate by coordinate, and may change Γ so
/// that the air goes with them. Constraints act after the effects.
class Constraint {
 public:
  Constraint() = default;
  Constraint(const Constraint&) = delete;
  Constraint& operator=(const Constraint&) = delete;
  virtual ~Constraint() = default;

  /// Its name in the registry.
  virtual std::string_view name() const = 0;
  /// Called once, before the first step: marks what it holds in tracker.held(), which the tracker hands on to new
  /// vertices, and adds attributes. After a resume the marks of before are put back behind this.
  virtual void attach(lostopos::SurfaceTracker& tracker) = 0;

  /// Changes Γ before the step's velocity is evaluated; `velocities` tells what it would be. Called once a step.
  virtual void correct_circulation(const EffectStep& /*step*/, CirculationField& /*circulation*/,
                                   const SheetVelocities& /*velocities*/) {}
  /// Puts held vertices where they have to be at a stage of the integrator or at the end of the step: changes entries
  /// of `positions` (L, one a vertex slot).
  virtual void prescribe(const Stage& stage, std::span<lostopos::Vec3> positions) = 0;

  /// As for effects: what it has to remember from step to step besides attributes; null: nothing.
  virtual nlohmann::json state() const;
  virtual void restore(const nlohmann::json& state);
};

}  // namespace foamsim
