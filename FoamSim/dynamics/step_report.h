#pragma once

#include <optional>

#include "Base/timing/stage_times.h"
#include "LosTopos/surface_tracker.h"

namespace foamsim {

/// What one step did.
struct StepReport {
  base::StageTimes times;  ///< wall seconds by stage
  /// Energies over air density (L⁵/T²) at the start of the step. Circulation is known half a step before (as the step
  /// found it) and half a step after (as the effects left it); the kinetic energy is the bilinear form of the two,
  /// −Σ Γ̄_before (u_after·n) area: like the start's positions second-order accurate in dt, and conserved as leap-frog
  /// conserves it. It can fall below zero by O(dt²) where the air is almost at rest.
  double kinetic_energy = 0;
  double potential_energy = 0;
  /// Hydrodynamic impulse at that instant (mean of before and after), L⁴/T.
  lostopos::Vec3 impulse = lostopos::Vec3::Zero();
  double impulse_scale = 0;  ///< Σ|2Γ̄ area| there: what the impulse's size compares with, L⁴/T
  double wire_work = 0;      ///< energy that wires and rods have put into films and air by moving them, L⁵/T²
  long wire_iterations = 0;  ///< most that a solve for the air to go with them took
  /// @name Of the conservative dynamics; else as they are here
  ///@{
  double stable_dt = 0;           ///< longest step that the stiffest films bear, T
  long substeps = 1;              ///< in which the step was made for that, and for speed
  long viscosity_iterations = 0;  ///< most that a substep's implicit viscosity took; 60: it was not solved in full
  long midpoint_rounds = 0;       ///< most that a substep of `midpoint` took; 30: it was not solved in full
  double correction = 0;  ///< change of φ that gave back energy and impulse, root mean square as a share of φ's
  /// What move, topology and remeshing of the step before have put into the films and into the air, L⁵/T².
  double tracker_surface_energy = 0, tracker_kinetic_energy = 0;
  ///@}
  /// What of the step has changed the films' energy (tension times area, L⁵/T²) besides the predicted motion: the move,
  /// where collisions kept vertices from going where they should; topology; remeshing, and effects that settle the
  /// vertices behind it.
  double move_energy = 0, topology_energy = 0, remesh_energy = 0;
  /// The same of the air, where SimulationOptions::air_by_stage asks for it.
  std::optional<double> topology_air_energy, remesh_air_energy;
  /// Energy (L⁵/T²) that effects have put in from outside: in the films and the air before the step by bursts and
  /// displacements, by blowing into the air, and by velocities that they add into the films.
  double effect_work = 0;
  /// Rounds that the integrators `implicit` and `pbd` took for Γ; 100: it was not solved in full.
  long implicit_iterations = 0;
  long velocity_evaluations = 0;
  double motion_fraction = 1;             ///< of the predicted motion that the tracker could do
  lostopos::MoveStatistics move;          ///< collisions found and answered
  lostopos::RemeshStatistics remesh;      ///< operations done and refused
  lostopos::TopologyStatistics topology;  ///< films that joined, parted or vanished, and the events in order
};

}  // namespace foamsim
