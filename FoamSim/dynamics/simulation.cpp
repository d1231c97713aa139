#include "FoamSim/dynamics/simulation.h"

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
  if (!(options.dt > 0)) throw base::InputError("dt has to be > 0");
  if (parts.dynamics == nullptr) throw base::InputError("a simulation needs dynamics");
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
      resolution_(tracker_->options().resolution) {
  delta_ = parts_.dynamics->attach(tracker_->mesh(), {resolution_, options.delta});
  for (const auto& effect : parts_.effects) effect->attach(tracker_->mesh());
  for (const auto& constraint : parts_.constraints) constraint->attach(*tracker_);
  geometry_.update(tracker_->mesh(), solid());
  if (parts_.dynamics->remeshes_start() && options_.tracker.remeshing) remesh_start();
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
  const EffectStep step = effect_step();
  StepScope scope(step, *circulation_, parts_.effects, parts_.constraints, report);
  parts_.dynamics->advance(scope, predicted_);
  track(report);
  {
    const base::TimedScope timed(report.times, "geometry");
    geometry_.update(tracker_->mesh(), solid());
  }
  ++steps_;
  return report;
}

void Simulation::track(StepReport& report) {
  lostopos::TrackerStep done = tracker_->step(predicted_);
  report.times.add("move", done.move_seconds);
  if (options_.tracker.topology.enabled) report.times.add("topology", done.topology_seconds);
  if (options_.tracker.remeshing) report.times.add("remesh", done.remesh_seconds);
  settle(report);
  report.motion_fraction = done.move.fraction;
  report.move = done.move.statistics;
  topology_totals_.add(done.topology);
  report.topology = std::move(done.topology);
  report.remesh = done.remesh;
}

// What effects still have to say of where the vertices are; the tracker sees to it that nothing intersects.
void Simulation::settle(StepReport& report) {
  const auto positions = tracker_->mesh().positions();
  predicted_.assign(positions.begin(), positions.end());
  const EffectStep step = effect_step();
  bool changed = false;
  for (const auto& effect : parts_.effects) {
    const base::TimedScope timed(report.times, effect->name());
    changed = effect->settle(step, predicted_) || changed;
  }
  if (!changed) return;
  const base::TimedScope timed(report.times, "move");
  tracker_->advance(predicted_);
}

EffectStep Simulation::effect_step() const {
  return {tracker_->mesh(), geometry_, time(), options_.dt, held(), solid()};
}

double Simulation::potential_energy() const {
  double sum = 0;
  for (const auto& effect : parts_.effects) sum += effect->potential_energy(geometry_);
  return sum;
}

}  // namespace foamsim
