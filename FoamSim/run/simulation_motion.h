#pragma once

#include "FoamSim/run/measured_motion.h"

namespace foamsim {

/// A simulation on its way, measured when its metrics are asked for: a foam's take as long as some stages of a step.
class SimulationMotion : public MeasuredMotion {
 public:
  /// `start_volumes`: closed_region_volumes at the start of the run; `before`: of the step before, where there was one.
  SimulationMotion(Simulation simulation, std::vector<lostopos::RegionVolume> start_volumes,
                   const std::optional<StepReport>& before = std::nullopt);

  void step() override;
  long steps() const override { return simulation_.steps(); }
  double time() const override { return simulation_.time(); }
  const lostopos::SurfaceMesh& mesh() const override { return simulation_.mesh(); }
  const lostopos::run::StepWork& last() const override { return work_; }

  const Simulation& simulation() const { return simulation_; }
  const Metrics& metrics() const override;

 protected:
  /// Of the last step, or of the one before the first.
  const StepReport& report() const { return report_; }
  /// Measures now, as a stage "metrics" of the step.
  void measure_now();

 private:
  Simulation simulation_;
  std::vector<lostopos::RegionVolume> start_volumes_;
  StepReport report_;
  double step_seconds_ = 0;
  mutable std::optional<Metrics> metrics_;  // once measured
  lostopos::run::StepWork work_;
};

}  // namespace foamsim
