#include <cmath>
#include <numbers>

#include "FoamSim/studies/stability/cases/cases.h"
#include "FoamSim/studies/stability/motions.h"
#include "FoamSim/studies/stability/shapes/border_edits.h"
#include "LosTopos/shapes/voronoi_foam.h"

namespace foamsim::stability {
namespace {

constexpr long cells = 30;

// A cube of bubbles that have the volume of a ball of radius 1 each.
lostopos::SurfaceMesh foam() {
  lostopos::SurfaceMesh mesh = lostopos::voronoi_foam({.cells = cells, .seed = 1, .subdivisions = 1});
  transform(mesh, std::cbrt(4 * std::numbers::pi / 3 * cells), lostopos::Vec3::Zero());
  return mesh;
}

std::vector<CaseRun> runs(const CaseSetup& setup) {
  return {{"", [setup] { return simulated(setup, foam()); }, scaled_steps(2000, setup)}};
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
          .summary = "a random foam of 30 bubbles of radius 1 for 2,000 steps",
          .criterion = "energy, volumes and impulse within the limits of physics",
          .strategies = Strategies::averaging,
          .remeshing = Remeshing::on_only,
          .typical_triangles = 4000,
          .runs = runs,
          .judge = judge};
}

}  // namespace foamsim::stability
