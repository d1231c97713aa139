#include "FoamSim/scenes/shapes/double_bubble.h"
#include "FoamSim/studies/stability/cases/cases.h"
#include "FoamSim/studies/stability/motions.h"
#include "FoamSim/studies/stability/shapes/border_edits.h"
#include "LosTopos/mesh/measures.h"

namespace foamsim::stability {
namespace {

constexpr double sliver_height = 0.02;  // over h̄

std::unique_ptr<MeasuredMotion> start_of_slivers(const CaseSetup& setup) {
  lostopos::SurfaceMesh mesh = double_bubble(16);
  const double resolution = lostopos::mean_edge_length(mesh);
  press_slivers(mesh, sliver_height * resolution);
  return simulated(setup, std::move(mesh), {.resolution = resolution});
}

}  // namespace

StabilityCase border_slivers() {
  return {.name = "border-slivers",
          .summary = "double bubble (N = 16) with slivers 0.02 h high at every second border edge, 1,000 steps",
          .criterion = "energy, volumes and impulse within the limits of physics",
          .typical_triangles = 1000,
          .runs = [](const CaseSetup& setup) { return one_run(setup, start_of_slivers, 1000); },
          .judge = within_physics};
}

}  // namespace foamsim::stability
