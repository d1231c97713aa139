#include "FoamSim/scenes/shapes/double_bubble.h"
#include "FoamSim/studies/stability/cases/cases.h"
#include "FoamSim/studies/stability/motions.h"
#include "FoamSim/studies/stability/shapes/border_edits.h"
#include "LosTopos/mesh/measures.h"

namespace foamsim::stability {
namespace {

constexpr double wanted_stretch = 20;
constexpr long most_parts = 64;

std::unique_ptr<MeasuredMotion> start_of_stretched(const CaseSetup& setup) {
  const lostopos::SurfaceMesh plain = double_bubble(16);
  const double resolution = lostopos::mean_edge_length(plain);
  long parts = 1;
  lostopos::SurfaceMesh mesh = plain.clone();
  while (most_stretched_at_borders(mesh) < wanted_stretch && parts < most_parts)
    mesh = with_divided_borders(plain, ++parts);
  return simulated(setup, std::move(mesh), {.resolution = resolution});
}

}  // namespace

StabilityCase stretched_border() {
  return {.name = "stretched-border",
          .summary = "double bubble (N = 16) whose wall's triangles at the border are stretched 20 : 1, 1,000 steps",
          .criterion = "energy, volumes and impulse within the limits of physics",
          .typical_triangles = 1500,
          .runs = [](const CaseSetup& setup) { return one_run(setup, start_of_stretched, 1000); },
          .judge = within_physics};
}

}  // namespace foamsim::stability
