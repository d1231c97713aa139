#include "FoamSim/scenes/shapes/double_bubble.h"
#include "FoamSim/studies/stability/cases/cases.h"
#include "FoamSim/studies/stability/motions.h"

namespace foamsim::stability {
namespace {

std::vector<CaseRun> runs_of_long_run(const CaseSetup& setup) {
  return {{"", [setup] { return simulated(setup, double_bubble(16)); }, scaled_steps(10000, setup)}};
}

Verdict judge_long_run(std::span<const Trajectory> t) {
  return Judgement()
      .require_physics(t[0])
      .set_figure("RMS angle deviation (deg)", t[0].samples.empty() ? std::nullopt : t[0].samples.back().angle_rms_deg)
      .verdict();
}

}  // namespace

StabilityCase long_double_bubble() {
  return {.name = "long",
          .summary = "the N = 16 double bubble for 10,000 steps of 0.01",
          .criterion = "energy, volumes and impulse within the limits of physics",
          .typical_triangles = 1000,
          .runs = runs_of_long_run,
          .judge = judge_long_run};
}

}  // namespace foamsim::stability
