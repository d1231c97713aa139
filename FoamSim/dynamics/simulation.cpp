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

void require_usable(const SurfaceMesh& mesh, const SimulationOptions& options) {
  if (mesh.triangle_count() == 0) throw base::InputError("the start mesh has no triangles; a film needs at least one");
  if (!(options.dt > 0)) throw base::InputError("dt has to be > 0");
  if (options.delta < 0 || options.resolution < 0) throw base::InputError("delta and resolution have to be >= 0");
}

std::unique_ptr<lostopos::SurfaceTracker> make_tracker(SurfaceMesh mesh, const SimulationOptions& options) {
  require_usable(mesh, options);
  lostopos::TrackerOptions tracker = options.tracker;
  tracker.resolution = resolved_resolution(options, mesh);
  return std::make_unique<lostopos::SurfaceTracker>(std::move(mesh), tracker);
}

}  // namespace

double resolved_resolution(const SimulationOptions& options, const SurfaceMesh& mesh) {
  return options.resolution > 0 ? options.resolution : lostopos::mean_edge_length(mesh);
}

Simulation::Simulation(SurfaceMesh mesh, const SimulationOptions& options, std::vector<std::unique_ptr<Effect>> effects,
                       std::span<const Vertex> held)
    : options_(options),
      tracker_(make_tracker(std::move(mesh), options)),
      circulation_(std::make_unique<CirculationField>(tracker_->mesh())),
      effects_(std::move(effects)),
      velocity_(make_biot_savart("direct")),
      resolution_(tracker_->options().resolution),
      delta_(options.delta > 0 ? options.delta : 0.75 * resolution_) {
  for (Vertex v : held) tracker_->held()[v] = lostopos::Hold::all;
  geometry_.update(tracker_->mesh(), solid());
}

std::span<const lostopos::Hold> Simulation::held() const {
  return std::as_const(*tracker_).held().slots();
}

std::span<const std::uint8_t> Simulation::solid() const {
  return std::as_const(*tracker_).solid().slots();
}

StepReport Simulation::step() {
  StepReport report;
  const long evaluations_before = velocity_.evaluations();
  const std::vector<double> before = gather_circulation();
  apply_effects(report.times);
  {
    const base::TimedScope timed(report.times, "velocity");
    const std::vector<double> after = gather_circulation();
    const auto positions = tracker_->mesh().positions();
    const VelocityFunction velocity_at = [this](std::span<const Vec3> x, std::span<Vec3> u) {
      velocity_.evaluate(sheet_, x, x, delta_, u);
    };
    velocities_.resize(positions.size());
    velocity_at(positions, velocities_);
    measure(before, after, report);
    integrate(options_.integrator, options_.dt, positions, velocities_, velocity_at, predicted_);
  }
  move_vertices(report.times);
  track(report);
  {
    const base::TimedScope timed(report.times, "geometry");
    geometry_.update(tracker_->mesh(), solid());
  }
  ++steps_;
  report.velocity_evaluations = velocity_.evaluations() - evaluations_before;
  return report;
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

void Simulation::move_vertices(base::StageTimes& times) {
  for (const auto& effect : effects_) {
    const base::TimedScope timed(times, effect->name());
    effect->move_vertices(effect_step(), predicted_);
  }
  const auto held_slots = held();
  for (std::size_t i = 0; i < held_slots.size(); ++i)
    for (int k = 0; k < 3; ++k)
      if (holds(held_slots[i], k)) predicted_[i][k] = tracker_->mesh().positions()[i][k];
}

void Simulation::apply_effects(base::StageTimes& times) {
  const EffectStep step = effect_step();
  for (const auto& effect : effects_) {
    const base::TimedScope timed(times, effect->name());
    effect->update_circulation(step, *circulation_);
  }
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
  for (const auto& effect : effects_) sum += effect->potential_energy(geometry_);
  return sum;
}

}  // namespace foamsim
