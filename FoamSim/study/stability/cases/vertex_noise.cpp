#include "FoamSim/scenes/shapes/double_bubble.h"
#include "FoamSim/study/stability/cases/cases.h"
#include "FoamSim/study/stability/motions.h"
#include "FoamSim/study/stability/shapes/border_edits.h"
#include "LosTopos/mesh/measures.h"

namespace foamsim::stability {
namespace {

std::vector<CaseRun> runs(const CaseSetup& setup) {
  auto start = [setup] {
    lostopos::SurfaceMesh mesh = double_bubble(16);
    const double resolution = lostopos::mean_edge_length(mesh);
    add_noise(mesh, 1e-3 * resolution, 7);
    return simulated(setup, std::move(mesh), {.resolution = resolution});
  };
  return {{"", start, scaled_steps(2000, setup)}};
}

Verdict judge(std::span<const Trajectory> t) {
  return Judgement().require_physics(t[0]).verdict();
}

}  // namespace

StabilityCase vertex_noise() {
  return {.name = "noise",
          .summary = "double bubble (N = 16) with random noise of 1e-3 h on every vertex, 2,000 steps",
          .criterion = "energy, volumes and impulse within the limits of physics",
          .typical_triangles = 1000,
          .runs = runs,
          .judge = judge};
}

}  // namespace foamsim::stability
