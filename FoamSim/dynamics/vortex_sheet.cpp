#include "FoamSim/dynamics/vortex_sheet.h"

#include <map>
#include <optional>

#include "Base/timing/stopwatch.h"
#include "FoamSim/sheet/area_gradient.h"
#include "FoamSim/sheet/burst_transfer.h"
#include "FoamSim/sheet/energy.h"
#include "FoamSim/sheet/region_constants.h"
#include "FoamSim/sheet/velocity/interaction.h"
#include "LosTopos/mesh/measures.h"

namespace foamsim {

using lostopos::Region;
using lostopos::SurfaceMesh;
using lostopos::Triangle;
using lostopos::Vec3;
using lostopos::Vertex;

double VortexSheet::attach(lostopos::SurfaceMesh& /*mesh*/, const DynamicsStart& start) {
  delta_ = start.delta > 0 ? start.delta : 0.75 * start.resolution;
  return delta_;
}

void VortexSheet::advance(StepScope& scope, std::vector<Vec3>& predicted) {
  const long evaluations_before = velocity_.evaluations();
  const std::vector<double> before = gather_circulation(scope);
  std::optional<Drive> drive;
  if (scope.drives()) drive = this->drive(scope);
  change_circulation(scope);
  {
    const base::TimedScope timed(scope.report().times, "velocity");
    const std::vector<double> after = gather_circulation(scope);
    const auto positions = scope.positions();
    velocities_.resize(positions.size());
    velocity_.evaluate(sheet_, positions, positions, delta_, velocities_);
    measure(scope, before, after);
    if (drive) scope.report().effect_work += work_of(*drive, scope);
  }
  if (!scope.step().mouth.empty()) let_in(scope);
  predict(scope, predicted);
  scope.report().velocity_evaluations = velocity_.evaluations() - evaluations_before;
}

// Drives the air, and notes the vortices before it and their change by it.
VortexSheet::Drive VortexSheet::drive(StepScope& scope) {
  const base::TimedScope timed(scope.report().times, "work");
  Drive drive;
  fill_vortex_sources(sheet_, scope.positions(), drive.before);
  std::vector<SheetTriangle> change = sheet_;
  scope.drive_circulation();
  gather_sheet(scope.mesh(), scope.circulation(), sheet_, scope.solid());
  for (std::size_t i = 0; i < sheet_.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) change[i].circulation[k] = sheet_[i].circulation[k] - change[i].circulation[k];
  fill_vortex_sources(change, scope.positions(), drive.change);
  return drive;
}

// K is quadratic in Γ, so the share of one of several changes goes with the mean of the potentials before and after
// all; the mean of the vortices has it at once.
double VortexSheet::work_of(const Drive& drive, StepScope& scope) {
  const base::TimedScope timed(scope.report().times, "work");
  VortexSources mean;
  fill_vortex_sources(sheet_, scope.positions(), mean);
  const auto average = [](VortexSources::Array& after, const VortexSources::Array& before) {
    for (std::size_t t = 0; t < after.size(); ++t) after[t] = (before[t] + after[t]) / 2;
  };
  average(mean.gx, drive.before.gx);
  average(mean.gy, drive.before.gy);
  average(mean.gz, drive.before.gz);
  return interaction(drive.change, mean, delta_, *pairs_);
}

// Of every region with a mouth: what the velocities let into it in the step.
void VortexSheet::let_in(StepScope& scope) const {
  const SurfaceMesh& mesh = scope.mesh();
  std::map<Region, double> rates;
  for (Triangle t : mesh.triangles())
    for (Vertex v : mesh.vertices(t))
      if (scope.step().is_mouth(v))
        for (Region r : {mesh.labels(t).p, mesh.labels(t).q})
          if (r != lostopos::air) rates[r] = 0;
  for (const SheetTriangle& sheet : sheet_) {
    Vec3 mean = Vec3::Zero();
    for (Vertex v : sheet.vertices)
      if (!scope.step().is_held(v)) mean += velocities_[v.index()] / 3;
    const double rate = mean.dot(lostopos::area_vector(mesh, sheet.triangle));
    const lostopos::Labels labels = mesh.labels(sheet.triangle);
    if (const auto it = rates.find(labels.p); it != rates.end()) it->second += rate;
    if (const auto it = rates.find(labels.q); it != rates.end()) it->second -= rate;
  }
  for (const auto& [region, rate] : rates) scope.let_in(region, rate * scope.step().dt);
}

AirState VortexSheet::air(const EffectStep& step, CirculationField& circulation) {
  gather_sheet(step.mesh, circulation, sheet_, step.solid);
  VortexSources sources;
  fill_vortex_sources(sheet_, step.mesh.positions(), sources);
  // By the potential, which is right also where films end at a wire.
  return {.kinetic_energy = interaction(sources, sources, delta_, *pairs_) / 2};
}

void VortexSheet::before_burst(const EffectStep& step, CirculationField& circulation, Region region) {
  join_circulation_to_air(step.mesh, region, circulation);
}

void VortexSheet::kick(StepScope& scope) {
  const base::TimedScope timed(scope.report().times, "integrator");
  scope.report().implicit_iterations =
      integrator_->kick({.step = scope.step(),
                         .circulation = scope.circulation(),
                         .sigma = scope.tension() / 4,
                         .delta = delta_,
                         .velocity = [&](std::span<const SheetTriangle> sheet, std::span<Vec3> velocity) {
                           velocity_.evaluate(sheet, scope.positions(), scope.positions(), delta_, velocity);
                         }});
}

void VortexSheet::change_circulation(StepScope& scope) {
  if (integrator_->takes_tension()) kick(scope);
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
