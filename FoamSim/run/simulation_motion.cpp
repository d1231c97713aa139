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
      metrics_(measure(simulation_, before ? *before : nothing_done(simulation_), start_volumes_)) {}

void SimulationMotion::step() {
  const base::Stopwatch watch;
  StepReport report = simulation_.step();
  const base::Stopwatch measuring;
  metrics_ = measure(simulation_, report, start_volumes_);
  work_ = {std::move(report.times), report.move, std::move(report.topology), report.remesh};
  work_.times.add("metrics", measuring.seconds());
  metrics_.step_seconds = watch.seconds();
}

}  // namespace foamsim
