#include "FoamSim/dynamics/simulation.h"

#include <cmath>
#include <utility>

#include "Base/error.h"
#include "Base/timing/stopwatch.h"
#include "LosTopos/mesh/measures.h"

namespace foamsim {

using lostopos::SurfaceMesh;
using lostopos::Vec3;
using lostopos::Vertex;

namespace {

void require_usable(const SurfaceMesh& mesh, const SimulationOptions& options, const SimulationParts& parts) {
  if (mesh.triangle_count() == 0) throw base::InputError("the start mesh has no triangles; a film needs at least one");
  if (!(options.dt >= 0)) throw base::InputError("dt has to be >= 0");
  if (parts.dynamics == nullptr) throw base::InputError("a simulation needs dynamics");
  if (options.delta < 0 || options.resolution < 0) throw base::InputError("delta and resolution have to be >= 0");
}

std::unique_ptr<lostopos::SurfaceTracker> make_tracker(SurfaceMesh mesh, const SimulationOptions& options,
                                                       const SimulationParts& parts) {
  require_usable(mesh, options, parts);
  lostopos::TrackerOptions tracker = options.tracker;
  tracker.resolution = resolved_resolution(options, mesh);
  tracker.keep_motion = options.follow_vertices;
  return std::make_unique<lostopos::SurfaceTracker>(std::move(mesh), tracker);
}

// To two digits, so that the step can be written down and given again.
double rounded_down(double value) {
  const double digits = 1 - std::floor(std::log10(value)), power = std::pow(10, std::abs(digits));
  return digits > 0 ? std::floor(value * power) / power : std::floor(value / power) * power;
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
      resolution_(tracker_->options().resolution) {
  delta_ = parts_.dynamics->attach(tracker_->mesh(), {resolution_, options.delta});
  for (const auto& effect : parts_.effects) effect->attach(tracker_->mesh());
  for (const auto& constraint : parts_.constraints) constraint->attach(*tracker_);
  geometry_.update(tracker_->mesh(), solid());
  for (const auto& effect : parts_.effects) effect->begin(effect_step());
  if (parts_.dynamics->remeshes_start() && options_.tracker.remeshing) remesh_start();
  if (options_.follow_vertices) vertex_ids_.emplace(tracker_->mesh());
  if (options_.dt == 0) options_.dt = chosen_dt();
}

double Simulation::chosen_dt() const {
  const double suitable = parts_.dynamics->suitable_dt(effect_step(), tension());
  if (!(suitable > 0)) throw base::InputError("dt=auto needs dynamics that know how long a step may be; give dt");
  if (!std::isfinite(suitable))
    throw base::InputError("dt=auto needs films under tension (sigma > 0), which is what limits a step; give dt");
  return rounded_down(suitable);
}

void Simulation::remesh_start() {
  StepReport report;
  tracker_->remesh();
  settle(report);
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
  change_surface(report);
  const EffectStep step = effect_step();
  StepScope scope(step, *circulation_, parts_.effects, parts_.constraints, report);
  parts_.dynamics->advance(scope, predicted_);
  track(report);
  {
    const base::TimedScope timed(report.times, "geometry");
    geometry_.update(tracker_->mesh(), solid());
  }
  if (vertex_ids_) vertex_ids_->number_new();
  ++steps_;
  return report;
}

double Simulation::tension() const {
  double sum = 0;
  for (const auto& effect : parts_.effects) sum += effect->tension();
  return sum;
}

void Simulation::track(StepReport& report) {
  double air = 0;
  const auto measure = [&](lostopos::TrackerStage stage) {
    const double now = air_energy();
    if (stage == lostopos::TrackerStage::topology) *report.topology_air_energy += now - air;
    if (stage == lostopos::TrackerStage::remesh) *report.remesh_air_energy += now - air;
    air = now;
  };
  if (options_.air_by_stage) report.topology_air_energy = report.remesh_air_energy = 0.0;
  lostopos::TrackerStep done =
      tracker_->step(predicted_, {}, options_.air_by_stage ? lostopos::AfterStage(measure) : lostopos::AfterStage());
  report.times.add("move", done.move_seconds);
  if (options_.tracker.topology.enabled) report.times.add("topology", done.topology_seconds);
  if (options_.tracker.remeshing) report.times.add("remesh", done.remesh_seconds);
  const double settled = settle(report);
  if (options_.air_by_stage) measure(lostopos::TrackerStage::remesh);
  report.move_energy = tension() * done.move_area;
  report.topology_energy = tension() * done.topology_area;
  report.remesh_energy = tension() * (done.remesh_area + settled);
  report.motion_fraction = done.move.fraction;
  report.move = done.move.statistics;
  topology_totals_.add(done.topology);
  report.topology += done.topology;
  report.remesh = done.remesh;
}

// Of the surface as it lies, within a step.
double Simulation::air_energy() {
  geometry_.update(tracker_->mesh(), solid());
  return parts_.dynamics->air(effect_step(), *circulation_).kinetic_energy;
}

// What effects still have to say of where the vertices are; the tracker sees to it that nothing intersects.
// Returns the area that is won by it, L².
double Simulation::settle(StepReport& report) {
  const auto positions = tracker_->mesh().positions();
  predicted_.assign(positions.begin(), positions.end());
  const EffectStep step = effect_step();
  bool changed = false;
  for (const auto& effect : parts_.effects) {
    const base::TimedScope timed(report.times, effect->name());
    changed = effect->settle(step, predicted_) || changed;
  }
  if (!changed) return 0;
  const base::TimedScope timed(report.times, "move");
  const double before = lostopos::total_area(tracker_->mesh());
  tracker_->advance(predicted_);
  return lostopos::total_area(tracker_->mesh()) - before;
}

EffectStep Simulation::effect_step() const {
  EffectStep step{tracker_->mesh(), geometry_, time(), options_.dt, held(), solid()};
  for (const auto& effect : parts_.effects)
    if (const auto mouth = effect->mouth(step.time); !mouth.empty()) step.mouth = mouth;
  return step;
}

double Simulation::potential_energy() const {
  double sum = 0;
  for (const auto& effect : parts_.effects) sum += effect->potential_energy(geometry_);
  return sum;
}

}  // namespace foamsim
