#include <cmath>

#include "FoamSim/scenes/shapes/exact_double_bubble.h"
#include "FoamSim/studies/stability/cases/cases.h"
#include "FoamSim/studies/stability/motions.h"

namespace foamsim::stability {

using lostopos::Vec3;

namespace {

constexpr double small_volume = 0.1, other_volume = 4, flow_dt = 0.02;
constexpr long edges_around_border = 18;
// The flow −x w towards the middle of the small bubble's rim; w = exp(−(|x|/reach)⁴) leaves the far side where it is.
constexpr double reach = 1.0;
constexpr long steps = 300;  // lengths shrink by e⁻⁶

Vec3 flow(const Vec3& x) {
  const double weight = std::exp(-std::pow(x.norm() / reach, 4));
  return x * (1 - flow_dt * weight);
}

std::vector<CaseRun> runs_of_shrinking(const CaseSetup& setup) {
  // All the steps in any case: a bubble shrunk half way has not vanished.
  auto start = [setup] {
    const auto exact = double_bubble_equilibrium(small_volume, other_volume);
    return prescribed(setup, exact_double_bubble(exact, edges_around_border), flow_dt, flow);
  };
  return {{"", start, steps}};
}

double last_volume(const Metrics& m, lostopos::Region region) {
  for (const auto& entry : m.volumes)
    if (entry.region == region) return entry.volume;
  return 0;
}

// By how much the other bubble's volume changes while the small one goes, as a share of it: the flow itself takes 0.2%
// a step.
double jump_of_the_other(const std::vector<Metrics>& samples) {
  for (std::size_t i = 1; i < samples.size(); ++i) {
    if (last_volume(samples[i], lostopos::Region(1)) > 0 || last_volume(samples[i - 1], lostopos::Region(1)) == 0)
      continue;
    return std::abs(last_volume(samples[i], lostopos::Region(2)) / last_volume(samples[i - 1], lostopos::Region(2)) -
                    1);
  }
  return 0;
}

Verdict judge_shrinking(std::span<const Trajectory> t) {
  Judgement judgement;
  judgement.require_sound(t[0]);
  if (t[0].samples.empty()) return judgement.verdict();
  const double left = last_volume(t[0].samples.back(), lostopos::Region(1)) / small_volume;
  return judgement.require(left == 0, "the bubble is still there")
      .require(last_volume(t[0].samples.back(), lostopos::Region(2)) > 0, "the other bubble is gone, too")
      .require(jump_of_the_other(t[0].samples) < 0.01, "the other bubble's volume jumps by 1% when the small one goes")
      .set_figure("volume left", left)
      .verdict();
}

}  // namespace

StabilityCase shrinking_bubble() {
  return {.name = "shrinking",
          .summary = "the smaller bubble of a pair shrinks to nothing by a prescribed flow in 300 steps",
          .criterion =
              "it vanishes (no triangle left), and the other bubble keeps its volume to 1% in that step; audits clean",
          .strategies = Strategies::none,
          .remeshing = Remeshing::on_only,
          .typical_triangles = 500,
          .runs = runs_of_shrinking,
          .judge = judge_shrinking};
}

}  // namespace foamsim::stability
