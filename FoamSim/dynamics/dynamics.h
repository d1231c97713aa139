#pragma once

#include <functional>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string_view>
#include <vector>

#include "FoamSim/constraints/constraint.h"
#include "FoamSim/dynamics/step_report.h"
#include "FoamSim/effects/effect.h"
#include "FoamSim/sheet/circulation.h"
#include "FoamSim/sheet/surface_geometry.h"
#include "LosTopos/surface_tracker.h"

namespace foamsim {

/// The step that a simulation makes, as its dynamics see it: the surface, Γ, and what effects and constraints have to
/// say. Times of the latter are charged to them by name.
class StepScope {
 public:
  StepScope(const EffectStep& step, CirculationField& circulation, const std::vector<std::unique_ptr<Effect>>& effects,
            const std::vector<std::unique_ptr<Constraint>>& constraints, StepReport& report)
      : step_(step), circulation_(circulation), effects_(effects), constraints_(constraints), report_(report) {}

  const EffectStep& step() const { return step_; }
  const lostopos::SurfaceMesh& mesh() const { return step_.mesh; }
  std::span<const lostopos::Vec3> positions() const { return step_.mesh.positions(); }
  /// By triangle slot, not zero for those of a solid.
  std::span<const std::uint8_t> solid() const { return step_.solid; }
  CirculationField& circulation() { return circulation_; }
  StepReport& report() { return report_; }

  /// Whether an effect drives the air from outside in this step.
  bool drives() const;
  /// Effects that do change Γ, to be called before `change_circulation`.
  void drive_circulation();
  /// Effects change Γ, in their order, then constraints, which may ask for the velocity that the air would have.
  void change_circulation(const SheetAir& air);
  /// How held vertices move with which the air has to go; empty arrays: there are none.
  HeldMotion held_motion() const;
  /// The effects' own velocities at vertices as the step begins, added to `velocity`.
  void add_effect_velocity(std::span<const lostopos::Vertex> at, std::span<lostopos::Vec3> velocity);
  /// Adds the effects' and constraints' own velocities at an instant `after` (T) the start of the step.
  void add_velocity(double after, std::span<const lostopos::Vec3> positions, std::span<lostopos::Vec3> velocity);
  /// Adds the gradients of the effects' potential energies at `positions`, by vertex slot, L⁴/T².
  void add_force(double after, std::span<const lostopos::Vec3> positions, std::span<lostopos::Vec3> force);
  /// Tells effects of the volume (L³) that a region gets in this step through a mouth.
  void let_in(lostopos::Region region, double volume);
  /// Effects and constraints change positions that have been arrived at.
  void correct_positions(double after, std::span<lostopos::Vec3> positions);
  /// Sum of the effects' potential energies of the surface at the start of the step.
  double potential_energy() const;
  /// Sum of the effects' tensions, L³/T².
  double tension() const;
  /// The same with the vertices at other positions.
  double potential_energy(double after, std::span<const lostopos::Vec3> positions) const;

 private:
  double work_of(std::span<const lostopos::Vec3> velocity) const;

  const EffectStep& step_;
  CirculationField& circulation_;
  const std::vector<std::unique_ptr<Effect>>& effects_;
  const std::vector<std::unique_ptr<Constraint>>& constraints_;
  StepReport& report_;
};

/// What is known of the surface before the first step.
struct DynamicsStart {
  double resolution;  ///< h̄, L
  double delta;       ///< δ as it was asked for, L; 0: the dynamics' own choice
};

/// Kinetic energy of the air over density (L⁵/T²), its impulse (L⁴/T) and angular impulse (L⁵/T) about the point that
/// the dynamics have chosen; the last two only where dynamics keep them.
struct AirState {
  double kinetic_energy = 0;
  lostopos::Vec3 impulse = lostopos::Vec3::Zero(), angular_impulse = lostopos::Vec3::Zero();
};

/// How films move: from the surface and Γ to Γ and the positions after dt. `vortex_sheet` is section 3 of the method
/// (Da et al. 2015), `conservative` section 12.
class Dynamics {
 public:
  Dynamics() = default;
  Dynamics(const Dynamics&) = delete;
  Dynamics& operator=(const Dynamics&) = delete;
  virtual ~Dynamics() = default;

  /// Called once, before the first step: adds what the mesh has to carry, and chooses δ, which it returns (L).
  virtual double attach(lostopos::SurfaceMesh& mesh, const DynamicsStart& start) = 0;
  /// Whether the start surface is remeshed once before the first step, where remeshing is on.
  virtual bool remeshes_start() const { return false; }
  /// The longest step (T) that suits films of such a tension (sum of the effects', L³/T²) as they lie; infinite: any
  /// does; 0: the dynamics cannot tell.
  virtual double suitable_dt(const EffectStep& /*step*/, double /*tension*/) { return 0; }
  /// Whether films that end at a free edge have to be held there: where nothing else holds anything, a frame does.
  virtual bool needs_held_edges() const { return false; }
  /// Whether it changes Γ by the films' tension itself, so that the effect must not.
  virtual bool takes_tension() const { return false; }

  /// @name Around what effects do to the surface before a step
  /// `step` has the surface as it is, with its geometry.
  ///@{
  /// What moves, for the balance; with Γ as it is.
  virtual AirState air(const EffectStep& step, CirculationField& circulation) = 0;
  /// Before `region` bursts: joins Γ of its films to that of the air's films that they become.
  virtual void before_burst(const EffectStep& step, CirculationField& circulation, lostopos::Region region) = 0;
  /// After it, when Γ is held for the pairs that are left.
  virtual void after_burst(const EffectStep& /*step*/, CirculationField& /*circulation*/) {}
  /// What was done to the surface has changed the balance: dynamics that keep it go on from there.
  virtual void surface_changed(const AirState& /*before*/, const AirState& /*after*/, double /*films_energy*/) {}
  ///@}

  /// Changes Γ over dt, writes the positions that the vertices are to go to (L, by slot), and fills energies and
  /// impulse of the report.
  virtual void advance(StepScope& scope, std::vector<lostopos::Vec3>& predicted) = 0;

  /// As for effects: what it has to remember from step to step besides attributes; null: nothing.
  virtual nlohmann::json state() const;
  virtual void restore(const nlohmann::json& state);
};

}  // namespace foamsim
