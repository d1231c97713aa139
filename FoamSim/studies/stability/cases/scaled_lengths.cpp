#include <cmath>

#include "FoamSim/scenes/shapes/double_bubble.h"
#include "FoamSim/studies/stability/cases/cases.h"
#include "FoamSim/studies/stability/motions.h"
#include "FoamSim/studies/stability/shapes/border_edits.h"

namespace foamsim::stability {
namespace {

constexpr double up = 0x1p20, down = 0x1p-20, scaled_tolerance = 1e-12;

CaseRun scaled_run(const CaseSetup& setup, std::string label, double scale) {
  auto start = [setup, scale] {
    lostopos::SurfaceMesh mesh = double_bubble(16);
    transform(mesh, scale, lostopos::Vec3::Zero());
    const double volume = scale * scale * scale;
    return simulated(setup, std::move(mesh), {.sigma = volume, .viscosity = volume});
  };
  return {std::move(label), start, scaled_steps(200, setup)};
}

std::vector<CaseRun> runs_of_scaled(const CaseSetup& setup) {
  return {scaled_run(setup, "as it is", 1), scaled_run(setup, "times 2^20", up),
          scaled_run(setup, "times 2^-20", down)};
}

Verdict judge_scaled(std::span<const Trajectory> t) {
  const double difference = std::max(largest_difference(t[0], t[1], up, lostopos::Vec3::Zero()),
                                     largest_difference(t[0], t[2], down, lostopos::Vec3::Zero()));
  return Judgement()
      .require_sound(t[0])
      .require_sound(t[1])
      .require_sound(t[2])
      .require(difference <= scaled_tolerance, "the scaled motions are not the same to 1e-12")
      .set_figure("largest relative difference", difference)
      .verdict();
}

}  // namespace

StabilityCase scaled_lengths() {
  return {.name = "scaled",
          .summary =
              "double bubble (N = 16) with lengths times 2^20 and 2^-20, sigma and viscosity with the cube, 200 steps",
          .criterion = "the same motion to 1e-12: measures of every step and all vertices at the end",
          .typical_triangles = 1000,
          .runs = runs_of_scaled,
          .judge = judge_scaled};
}

}  // namespace foamsim::stability
