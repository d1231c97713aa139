#include "FoamSim/scenes/shapes/exact_double_bubble.h"
#include "FoamSim/studies/stability/cases/cases.h"
#include "FoamSim/studies/stability/motions.h"

namespace foamsim::stability {
namespace {

// The smaller bubble's radius is about 0.1; its time scale √(r³/σ) about 0.03.
constexpr double large_volume = 4, ratio = 1000, dt = 0.002;
constexpr long edges_around_its_border = 9;

std::unique_ptr<MeasuredMotion> start_of_ratio(const CaseSetup& setup) {
  const auto exact = double_bubble_equilibrium(large_volume / ratio, large_volume);
  return simulated(setup, exact_double_bubble(exact, edges_around_its_border), {.dt = dt});
}

}  // namespace

StabilityCase volume_ratio() {
  return {.name = "volume-ratio",
          .summary = "a double bubble of volumes 1 : 1,000 at rest, for 200 steps of 0.002",
          .criterion = "energy, volumes (the small bubble's too) and impulse within the limits of physics",
          .typical_triangles = 8000,
          .runs = [](const CaseSetup& setup) { return one_run(setup, start_of_ratio, 200); },
          .judge = within_physics};
}

}  // namespace foamsim::stability
