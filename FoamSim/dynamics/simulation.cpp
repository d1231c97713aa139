#include "FoamSim/dynamics/simulation.h"

#include <utility>

#include "Base/error.h"
#include "Base/timing/stopwatch.h"
#include "FoamSim/sheet/energy.h"
#include "FoamSim/sheet/region_constants.h"
#include "LosTopos/mesh/measures.h"

namespace foamsim {

using lostopos::SurfaceMesh;
using lostopos::Vec3;
using lostopos::Vertex;

namespace {

void require_usable(const SurfaceMesh& mesh, const SimulationOptions& options, const SimulationParts& parts) {
  if (mesh.triangle_count() == 0) throw base::InputError("the start mesh has no triangles; a film needs at least one");
  if (!(options.dt > 0)) throw base::InputError("dt has to be > 0");
  if (parts.velocity == nullptr || parts.integrator == nullptr)
    throw base::InputError("a simulation needs a velocity sum and an integrator");
  if (options.delta < 0 || options.resolution < 0) throw base::InputError("delta and resolution have to be >= 0");
}

std::unique_ptr<lostopos::SurfaceTracker> make_tracker(SurfaceMesh mesh, const SimulationOptions& options,
                                                       const SimulationParts& parts) {
  require_usable(mesh, options, parts);
  lostopos::TrackerOptions tracker = options.tracker;
  tracker.resolution = resolved_resolution(options, mesh);
  return std::make_unique<lostopos::SurfaceTracker>(std::move(mesh), tracker);
}

}  // namespace

double resolved_resolution(const SimulationOptions& options, const SurfaceMesh& mesh) {
  return options.resolution > 0 ? options.resolution : lostopos::mean_edge_length(mesh);
}

Simulation::Simulation(SurfaceMesh mesh, const SimulationOptions& options, SimulationParts parts)
    : options_(options),
      tracker_(make_tracker(std::move(mesh), options, parts)),
      circulation_(std::make_unique<CirculationField>(tracker_->mesh())),
      parts_(std::move(parts)),
      velocity_(std::move(parts_.velocity)),
      resolution_(tracker_->options().resolution),
      delta_(options.delta > 0 ? options.delta : 0.75 * resolution_) {
  for (const auto& effect : parts_.effects) effect->attach(tracker_->mesh());
  for (const auto& constraint : parts_.constraints) constraint->attach(*tracker_);
  geometry_.update(tracker_->mesh(), solid());
}

std::span<const lostopos::Hold> Simulation::held() const {
  return std::as_const(*tracker_).held().slots();
}

std::span<const std::uint8_t> Simulation::solid() const {
  return std::as_const(*tracker_).solid().slots();
}

StepReport Simulation::step() {
  save(before_);
  try {
    return make_step();
  } catch (...) {
    restore(before_);
    throw;
  }
}

StepReport Simulation::make_step() {
  StepReport report;
  const long evaluations_before = velocity_.evaluations();
  const std::vector<double> before = gather_circulation();
  change_circulation(report.times);
  {
    const base::TimedScope timed(report.times, "velocity");
    const std::vector<double> after = gather_circulation();
    const auto positions = tracker_->mesh().positions();
    velocities_.resize(positions.size());
    velocity_.evaluate(sheet_, positions, positions, delta_, velocities_);
    measure(before, after, report);
  }
  predict(report);
  track(report);
  {
    const base::TimedScope timed(report.times, "geometry");
    geometry_.update(tracker_->mesh(), solid());
  }
  ++steps_;
  report.velocity_evaluations = velocity_.evaluations() - evaluations_before;
  return report;
}

// Effects first, then constraints, which may want to know what the air would do.
void Simulation::change_circulation(base::StageTimes& times) {
  const EffectStep step = effect_step();
  for (const auto& effect : parts_.effects) {
    const base::TimedScope timed(times, effect->name());
    effect->update_circulation(step, *circulation_);
  }
  const SheetVelocities velocities = [this](std::span<Vec3> velocity) {
    gather_sheet(tracker_->mesh(), *circulation_, sheet_, solid());
    velocity_.evaluate(sheet_, tracker_->mesh().positions(), tracker_->mesh().positions(), delta_, velocity);
  };
  for (const auto& constraint : parts_.constraints) {
    const base::TimedScope timed(times, constraint->name());
    constraint->correct_circulation(step, *circulation_, velocities);
  }
}

// From the sheet's velocities at the start, which are known, to where the vertices are to go.
void Simulation::predict(StepReport& report) {
  const EffectStep step = effect_step();
  const auto positions = tracker_->mesh().positions();
  add_effects_velocity({step, step.time, positions}, velocities_, report.times);
  const StageMotion motion{
      .velocity =
          [&](double after, std::span<const Vec3> x, std::span<Vec3> u) {
            {
              const base::TimedScope timed(report.times, "velocity");
              velocity_.evaluate(sheet_, x, x, delta_, u);
            }
            add_effects_velocity({step, step.time + after, x}, u, report.times);
          },
      .correct = [&](double after, std::span<Vec3> x) { correct_positions(step.time + after, x, report.times); }};
  parts_.integrator->advance(options_.dt, positions, velocities_, motion, predicted_);
}

void Simulation::add_effects_velocity(const Stage& stage, std::span<Vec3> velocity, base::StageTimes& times) {
  for (const auto& effect : parts_.effects) {
    const base::TimedScope timed(times, effect->name());
    effect->add_velocity(stage, velocity);
  }
}

void Simulation::correct_positions(double time, std::span<Vec3> positions, base::StageTimes& times) {
  const EffectStep step = effect_step();
  for (const auto& effect : parts_.effects) {
    const base::TimedScope timed(times, effect->name());
    effect->move_vertices({step, time, positions}, positions);
  }
  for (const auto& constraint : parts_.constraints) {
    const base::TimedScope timed(times, constraint->name());
    constraint->prescribe({step, time, positions}, positions);
  }
}

void Simulation::track(StepReport& report) {
  lostopos::TrackerStep done = tracker_->step(predicted_);
  report.times.add("move", done.move_seconds);
  if (options_.tracker.topology.enabled) report.times.add("topology", done.topology_seconds);
  if (options_.tracker.remeshing) report.times.add("remesh", done.remesh_seconds);
  report.motion_fraction = done.move.fraction;
  report.move = done.move.statistics;
  topology_totals_.add(done.topology);
  report.topology = std::move(done.topology);
  report.remesh = done.remesh;
}

EffectStep Simulation::effect_step() const {
  return {tracker_->mesh(), geometry_, time(), options_.dt, held()};
}

std::vector<double> Simulation::gather_circulation() {
  gather_sheet(tracker_->mesh(), *circulation_, sheet_, solid());
  return circulation_without_region_constants(tracker_->mesh(), sheet_, tracker_->mesh().positions());
}

void Simulation::measure(std::span<const double> before, std::span<const double> after, StepReport& report) const {
  const auto positions = tracker_->mesh().positions();
  report.kinetic_energy = kinetic_energy(before, sheet_, positions, velocities_);
  report.potential_energy = potential_energy();
  std::vector<double> middle(before.size());
  for (std::size_t i = 0; i < middle.size(); ++i) middle[i] = (before[i] + after[i]) / 2;
  const Impulse impulse = hydrodynamic_impulse(middle, sheet_, positions);
  report.impulse = impulse.total;
  report.impulse_scale = impulse.scale;
}

double Simulation::potential_energy() const {
  double sum = 0;
  for (const auto& effect : parts_.effects) sum += effect->potential_energy(geometry_);
  return sum;
}

}  // namespace foamsim
