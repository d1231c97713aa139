#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string_view>
#include <vector>

#include "FoamSim/effects/effect_step.h"
#include "FoamSim/sheet/circulation.h"

namespace foamsim {

/// Something that acts on the sheet: constructed only for a scene that names it, with its own options and state.
class Effect {
 public:
  Effect() = default;
  Effect(const Effect&) = delete;
  Effect& operator=(const Effect&) = delete;
  virtual ~Effect() = default;

  /// Its name in the registry.
  virtual std::string_view name() const = 0;
  /// Called once, before the first step: the place to add named attributes to the mesh, which then follow it, are
  /// written and are resumed by themselves.
  virtual void attach(lostopos::SurfaceMesh& /*mesh*/) {}
  /// Called once, when all effects and constraints are attached, with the surface as it is before the first step. After
  /// a resume what attributes hold is put back behind this. Throws base::InputError for what the surface does not have.
  virtual void begin(const EffectStep& /*step*/) {}

  /// @name Before a step begins
  ///@{
  /// Regions that burst now: their films towards the air break, and what is left of them belongs to the air.
  virtual std::vector<lostopos::Region> bursts(const EffectStep& /*step*/) { return {}; }
  /// Whether it is one that lets regions burst.
  virtual bool lets_burst() const { return false; }
  /// Told of a region that is about to burst.
  virtual void region_bursts(lostopos::Region /*region*/) {}
  /// Where vertices are to go (L, one a slot) before the step moves them, as far as nothing intersects; empty: nowhere.
  virtual std::vector<lostopos::Vec3> displaced(const EffectStep& /*step*/) { return {}; }
  /// As EffectStep::mouth, of a step that begins at this time (T).
  virtual std::span<const std::uint8_t> mouth(double /*time*/) const { return {}; }
  ///@}

  /// Whether it drives the air from outside in a step that begins at this time (T).
  virtual bool drives(double /*time*/) const { return false; }
  /// Changes Γ over step.dt by what it does to the air from outside: before all that `update_circulation` does, and
  /// with the energy that this takes counted as work.
  virtual void drive_circulation(const EffectStep& /*step*/, CirculationField& /*circulation*/) {}
  /// Told of the volume (L³) that a region has got through a mouth.
  virtual void volume_let_in(lostopos::Region /*region*/, double /*volume*/) {}
  /// Changes Γ over step.dt. Called once a step, in the order of the registry, before velocities are evaluated.
  virtual void update_circulation(const EffectStep& /*step*/, CirculationField& /*circulation*/) {}
  /// Adds the gradient of its potential energy with respect to the vertices' positions (L⁴/T², one a vertex slot) at
  /// stage.positions. Only for dynamics that take forces (`conservative`); there it does not change Γ for them.
  virtual void add_force(const Stage& /*stage*/, std::span<lostopos::Vec3> /*force*/) {}
  /// Adds to the velocities (L/T, one a vertex slot) at a stage of the integrator, those that the sheet induces there:
  /// once a step for euler, four times for rk4.
  virtual void add_velocity(const Stage& /*stage*/, std::span<lostopos::Vec3> /*velocity*/) {}
  /// Told of what all effects together have added to the velocities at a stage, where that is anything.
  virtual void velocity_added(const Stage& /*stage*/, std::span<const lostopos::Vec3> /*added*/) {}
  /// Changes positions (L, one a vertex slot) that the integrator has arrived at: those of its stages, and those at the
  /// end of the step (stage.time is then time + dt); stage.positions are these positions. Held vertices go where their
  /// constraint says whatever this does.
  virtual void move_vertices(const Stage& /*stage*/, std::span<lostopos::Vec3> /*positions*/) {}
  /// After the tracker has moved, parted, joined and remeshed the surface: puts the vertices (L, one a slot) where it
  /// wants them instead, and returns whether it has changed any. `step` has the mesh as it is then; its geometry is of
  /// before.
  virtual bool settle(const EffectStep& /*step*/, std::span<lostopos::Vec3> /*positions*/) { return false; }
  /// Potential energy over air density (L⁵/T²) that it has given to the surface as it is now.
  virtual double potential_energy(const SurfaceGeometry& /*geometry*/) const { return 0.0; }
  /// The same of the surface with its vertices at stage.positions.
  virtual double potential_energy(const Stage& /*stage*/) const { return 0.0; }

  /// Energy of a film over density and area that it gives to every film (L³/T²): what makes short waves fast.
  virtual double tension() const { return 0.0; }

  /// What it has to remember from step to step besides attributes of the mesh; null: nothing. Kept in checkpoints, and
  /// put back when a step fails.
  virtual nlohmann::json state() const;
  /// Takes back what `state` gave. Throws base::InputError for anything else.
  virtual void restore(const nlohmann::json& state);
};

}  // namespace foamsim
