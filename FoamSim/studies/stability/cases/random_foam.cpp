#include <cmath>
#include <numbers>

#include "FoamSim/studies/stability/cases/cases.h"
#include "FoamSim/studies/stability/motions.h"
#include "FoamSim/studies/stability/shapes/border_edits.h"
#include "LosTopos/shapes/voronoi_foam.h"

namespace foamsim::stability {
namespace {

// A cube of bubbles that have the volume of a ball of radius 1 each.
lostopos::SurfaceMesh foam(long cells, long subdivisions) {
  lostopos::SurfaceMesh mesh = lostopos::voronoi_foam({.cells = cells, .seed = 1, .subdivisions = subdivisions});
  transform(mesh, std::cbrt(4 * std::numbers::pi / 3 * cells), lostopos::Vec3::Zero());
  return mesh;
}

template <long cells, long subdivisions, long steps>
std::vector<CaseRun> runs_of_foam(const CaseSetup& setup) {
  return {{"", [setup] { return simulated(setup, foam(cells, subdivisions)); }, scaled_steps(steps, setup)}};
}

Verdict judge_foam(std::span<const Trajectory> t) {
  return Judgement()
      .require_physics(t[0])
      .set_figure("T1s",
                  t[0].samples.empty() ? 0.0 : static_cast<double>(t[0].samples.back().topology_totals.separations))
      .verdict();
}

StabilityCase foam_case(std::string_view name, std::string_view summary, long triangles) {
  return {.name = name,
          .summary = summary,
          .criterion = "energy, volumes and impulse within the limits of physics",
          .strategies = Strategies::averaging,
          .remeshing = Remeshing::on_only,
          .typical_triangles = triangles,
          .judge = judge_foam};
}

}  // namespace

StabilityCase random_foam() {
  StabilityCase foam = foam_case("foam", "a random foam of 30 bubbles of radius 1 for 2,000 steps", 4000);
  foam.runs = runs_of_foam<30, 1, 2000>;
  return foam;
}

StabilityCase fine_foam() {
  StabilityCase foam = foam_case("fine-foam", "the same with triangles of half the size", 14000);
  foam.runs = runs_of_foam<30, 2, 2000>;
  foam.when_named = true;
  return foam;
}

StabilityCase large_foam() {
  StabilityCase foam = foam_case("large-foam", "a random foam of 100 bubbles of radius 1 for 500 steps", 45000);
  foam.runs = runs_of_foam<100, 2, 500>;
  foam.when_named = true;
  return foam;
}

}  // namespace foamsim::stability
