#include "FoamSim/dynamics/vortex_sheet.h"

#include "Base/timing/stopwatch.h"
#include "FoamSim/sheet/area_gradient.h"
#include "FoamSim/sheet/energy.h"
#include "FoamSim/sheet/region_constants.h"

namespace foamsim {

using lostopos::Vec3;

double VortexSheet::attach(lostopos::SurfaceMesh& /*mesh*/, const DynamicsStart& start) {
  delta_ = start.delta > 0 ? start.delta : 0.75 * start.resolution;
  return delta_;
}

void VortexSheet::advance(StepScope& scope, std::vector<Vec3>& predicted) {
  const long evaluations_before = velocity_.evaluations();
  const std::vector<double> before = gather_circulation(scope);
  change_circulation(scope);
  {
    const base::TimedScope timed(scope.report().times, "velocity");
    const std::vector<double> after = gather_circulation(scope);
    const auto positions = scope.positions();
    velocities_.resize(positions.size());
    velocity_.evaluate(sheet_, positions, positions, delta_, velocities_);
    measure(scope, before, after);
  }
  predict(scope, predicted);
  scope.report().velocity_evaluations = velocity_.evaluations() - evaluations_before;
}

void VortexSheet::change_circulation(StepScope& scope) {
  std::vector<Vec3> targets;
  scope.change_circulation({delta_, [&](std::span<const lostopos::Vertex> at, std::span<Vec3> velocity) {
                              gather_sheet(scope.mesh(), scope.circulation(), sheet_, scope.solid());
                              targets.clear();
                              for (lostopos::Vertex v : at) targets.push_back(scope.positions()[v.index()]);
                              velocity_.evaluate(sheet_, scope.positions(), targets, delta_, velocity);
                              scope.add_effect_velocity(at, velocity);
                            }});
}

// From the sheet's velocities at the start, which are known, to where the vertices are to go.
void VortexSheet::predict(StepScope& scope, std::vector<Vec3>& predicted) {
  const auto positions = scope.positions();
  scope.add_velocity(0, positions, velocities_);
  const StageMotion motion{.velocity =
                               [&](double after, std::span<const Vec3> x, std::span<Vec3> u) {
                                 {
                                   const base::TimedScope timed(scope.report().times, "velocity");
                                   velocity_.evaluate(sheet_, x, x, delta_, u);
                                 }
                                 scope.add_velocity(after, x, u);
                               },
                           .correct = [&](double after, std::span<Vec3> x) { scope.correct_positions(after, x); }};
  integrator_->advance(scope.step().dt, positions, velocities_, motion, predicted);
  count_wire_work(scope, predicted);
}

// What moving held vertices does to the films' area: the mean of the forces before and after, times the way.
void VortexSheet::count_wire_work(StepScope& scope, std::span<const Vec3> predicted) {
  const HeldMotion held = scope.held_motion();
  if (held.driven.empty()) return;
  std::vector<Vec3> forces(predicted.size(), Vec3::Zero());
  for (std::span<const Vec3> at : {scope.positions(), predicted})
    add_area_gradient(scope.mesh(), scope.solid(), at, scope.tension(), forces);
  for (std::size_t v = 0; v < held.driven.size(); ++v)
    if (held.driven[v] != 0) scope.report().wire_work += forces[v].dot(predicted[v] - scope.positions()[v]) / 2;
}

std::vector<double> VortexSheet::gather_circulation(StepScope& scope) {
  gather_sheet(scope.mesh(), scope.circulation(), sheet_, scope.solid());
  return circulation_without_region_constants(scope.mesh(), sheet_, scope.positions());
}

void VortexSheet::measure(StepScope& scope, std::span<const double> before, std::span<const double> after) const {
  StepReport& report = scope.report();
  const auto positions = scope.positions();
  report.kinetic_energy = kinetic_energy(before, sheet_, positions, velocities_);
  report.potential_energy = scope.potential_energy();
  std::vector<double> middle(before.size());
  for (std::size_t i = 0; i < middle.size(); ++i) middle[i] = (before[i] + after[i]) / 2;
  const Impulse impulse = hydrodynamic_impulse(middle, sheet_, positions);
  report.impulse = impulse.total;
  report.impulse_scale = impulse.scale;
}

}  // namespace foamsim
