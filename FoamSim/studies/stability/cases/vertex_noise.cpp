#include "FoamSim/scenes/shapes/double_bubble.h"
#include "FoamSim/studies/stability/cases/cases.h"
#include "FoamSim/studies/stability/motions.h"
#include "FoamSim/studies/stability/shapes/border_edits.h"
#include "LosTopos/mesh/measures.h"

namespace foamsim::stability {
namespace {

std::unique_ptr<MeasuredMotion> start_of_noise(const CaseSetup& setup) {
  lostopos::SurfaceMesh mesh = double_bubble(16);
  const double resolution = lostopos::mean_edge_length(mesh);
  add_noise(mesh, 1e-3 * resolution, 7);
  return simulated(setup, std::move(mesh), {.resolution = resolution});
}

}  // namespace

StabilityCase vertex_noise() {
  return {.name = "noise",
          .summary = "double bubble (N = 16) with random noise of 1e-3 h on every vertex, 2,000 steps",
          .criterion = "energy, volumes and impulse within the limits of physics",
          .typical_triangles = 1000,
          .runs = [](const CaseSetup& setup) { return one_run(setup, start_of_noise, 2000); },
          .judge = within_physics};
}

}  // namespace foamsim::stability
