#include "FoamSim/study/stability/cases/cases.h"
#include "FoamSim/study/stability/motions.h"
#include "LosTopos/shapes/voronoi_foam.h"

namespace foamsim::stability {
namespace {

std::vector<CaseRun> runs(const CaseSetup& setup) {
  // Bubbles of volume 1/30: radius 0.2, time scale √(r³/σ) = 0.09.
  auto start = [setup] {
    return simulated(setup, lostopos::voronoi_foam({.cells = 30, .seed = 1, .subdivisions = 1}), {.dt = 0.001});
  };
  return {{"", start, scaled_steps(2000, setup)}};
}

Verdict judge(std::span<const Trajectory> t) {
  return Judgement()
      .require_physics(t[0])
      .set_figure("T1s",
                  t[0].samples.empty() ? 0.0 : static_cast<double>(t[0].samples.back().topology_totals.separations))
      .verdict();
}

}  // namespace

StabilityCase random_foam() {
  return {.name = "foam",
          .summary = "a random foam of 30 bubbles for 2,000 steps of 0.001",
          .criterion = "energy, volumes and impulse within the limits of physics",
          .strategies = Strategies::averaged_only,
          .remeshing = Remeshing::on_only,
          .typical_triangles = 4000,
          .runs = runs,
          .judge = judge};
}

}  // namespace foamsim::stability
