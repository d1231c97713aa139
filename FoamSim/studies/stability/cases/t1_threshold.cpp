#include "FoamSim/studies/stability/cases/cases.h"
#include "FoamSim/studies/stability/motions.h"
#include "FoamSim/studies/stability/shapes/clusters.h"

namespace foamsim::stability {
namespace {

// The line in the middle has as many edges, and is where four films meet.
constexpr long edges_along_line = 6;
// Each of its vertices separates once; as many again for what remeshing adds.
constexpr long most_separations = 2 * (edges_along_line + 1);

std::vector<CaseRun> runs_of_t1(const CaseSetup& setup) {
  auto start = [setup] { return simulated(setup, block_of_cubes({2, 2, 1}, edges_along_line), {.dt = 0.005}); };
  return {{"", start, scaled_steps(1000, setup)}};
}

Verdict judge_t1(std::span<const Trajectory> t) {
  const auto& samples = t[0].samples;
  const long all = samples.empty() ? 0 : samples.back().topology_totals.separations;
  const long late = samples.empty() ? 0 : all - samples[samples.size() / 2].topology_totals.separations;
  return Judgement()
      .require_physics(t[0])
      .require(all > 0, "four films stay at one line: no T1")
      .require(all <= most_separations, std::to_string(all) + " T1s; at most " + std::to_string(most_separations))
      .require(late == 0, std::to_string(late) + " T1s in the second half: they flicker")
      .set_figure("T1s", static_cast<double>(all))
      .verdict();
}

}  // namespace

StabilityCase t1_threshold() {
  return {.name = "t1-threshold",
          .summary = "four bubbles around one line, which may open either way, 1,000 steps of 0.005",
          .criterion = "1 to 14 T1s, none in the second half; energy, volumes and impulse within the limits of physics",
          .remeshing = Remeshing::on_only,
          .typical_triangles = 1700,
          .runs = runs_of_t1,
          .judge = judge_t1};
}

}  // namespace foamsim::stability
