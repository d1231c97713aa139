#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string_view>
#include <vector>

#include "FoamSim/effects/effect_step.h"
#include "FoamSim/sheet/circulation.h"
#include "LosTopos/surface_tracker.h"

namespace foamsim {

/// The air at the start of the step, as a constraint may ask for it.
struct SheetAir {
  double delta = 0;  ///< the regularisation δ, L
  /// Writes the velocity (L/T) at vertices, as many as asked for, that the sheet's circulation as it is now and the
  /// effects give them; empty: the dynamics see to the air themselves (see Constraint::tell_motion).
  std::function<void(std::span<const lostopos::Vertex> at, std::span<lostopos::Vec3> velocity)> velocity;
};

/// What making the air go along took.
struct AirChange {
  long iterations = 0;  ///< of the linear solves
  double work = 0;      ///< energy that the air has gained by it, over density, L⁵/T²
};

/// Where held vertices go in a step, by vertex slot; for dynamics that make the air go along by themselves.
struct HeldMotion {
  std::vector<std::uint8_t> driven;         ///< not zero: it goes where it is sent
  std::vector<std::uint8_t> takes_air;      ///< not zero: and the films there take the air along
  std::vector<lostopos::Vec3> before, now;  ///< velocity as the step begins, and during it, L/T

  /// Makes room for all of the mesh; what is there stays.
  void resize(std::size_t vertex_slots) {
    driven.resize(vertex_slots, 0);
    takes_air.resize(vertex_slots, 0);
    before.resize(vertex_slots, lostopos::Vec3::Zero());
    now.resize(vertex_slots, lostopos::Vec3::Zero());
  }
};

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

  /// Changes Γ before the step's velocity is evaluated; `air` tells what it would be. Called once a step.
  virtual AirChange correct_circulation(const EffectStep& /*step*/, CirculationField& /*circulation*/,
                                        const SheetAir& /*air*/) {
    return {};
  }
  /// Adds to the velocities (L/T, one a vertex slot) at a stage of the integrator what it gives to the air besides Γ.
  virtual void add_velocity(const Stage& /*stage*/, std::span<lostopos::Vec3> /*velocity*/) {}
  /// Writes how the vertices move that it holds and with which the air has to go; called once a step, behind
  /// correct_circulation.
  virtual void tell_motion(const EffectStep& /*step*/, HeldMotion& /*motion*/) const {}
  /// Puts held vertices where they have to be at a stage of the integrator or at the end of the step: changes entries
  /// of `positions` (L, one a vertex slot).
  virtual void prescribe(const Stage& stage, std::span<lostopos::Vec3> positions) = 0;

  /// As for effects: what it has to remember from step to step besides attributes; null: nothing.
  virtual nlohmann::json state() const;
  virtual void restore(const nlohmann::json& state);
};

}  // namespace foamsim
