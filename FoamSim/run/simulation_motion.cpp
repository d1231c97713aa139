#include "FoamSim/run/simulation_motion.h"

#include "Base/timing/stopwatch.h"

namespace foamsim {
namespace {

StepReport nothing_done(const Simulation& simulation) {
  StepReport report;
  report.potential_energy = simulation.potential_energy();
  return report;
}

}  // namespace

SimulationMotion::SimulationMotion(Simulation simulation, std::vector<lostopos::RegionVolume> start_volumes,
                                   const std::optional<StepReport>& before)
    : simulation_(std::move(simulation)),
      start_volumes_(std::move(start_volumes)),
      report_(before ? *before : nothing_done(simulation_)) {}

void SimulationMotion::step() {
  const base::Stopwatch watch;
  report_ = simulation_.step();
  step_seconds_ = watch.seconds();
  metrics_.reset();
  work_ = {report_.times, report_.move, report_.topology, report_.remesh};
}

void SimulationMotion::measure_now() {
  const base::TimedScope timed(work_.times, "metrics");
  metrics();
}

const Metrics& SimulationMotion::metrics() const {
  if (!metrics_) {
    metrics_ = measure(simulation_, report_, start_volumes_);
    metrics_->step_seconds = step_seconds_;
  }
  return *metrics_;
}

}  // namespace foamsim
