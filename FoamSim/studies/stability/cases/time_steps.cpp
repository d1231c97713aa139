#include <array>
#include <cmath>

#include "Base/options/option_value.h"
#include "FoamSim/scenes/shapes/double_bubble.h"
#include "FoamSim/studies/stability/cases/cases.h"
#include "FoamSim/studies/stability/motions.h"

namespace foamsim::stability {
namespace {

constexpr std::array steps_of_time{0.0025, 0.005, 0.01, 0.02, 0.04, 0.08};
constexpr double usual = 0.01, duration = 4;

std::vector<CaseRun> runs_of_time_steps(const CaseSetup& setup) {
  std::vector<CaseRun> all;
  all.reserve(steps_of_time.size());
  for (double dt : steps_of_time)
    all.push_back({"dt " + base::to_text(dt), [setup, dt] { return simulated(setup, double_bubble(16), {.dt = dt}); },
                   scaled_steps(std::lround(duration / dt), setup)});
  return all;
}

Verdict judge_time_steps(std::span<const Trajectory> t) {
  std::optional<double> largest;
  Judgement judgement;
  for (std::size_t i = 0; i < t.size(); ++i) {
    const Verdict verdict = Judgement().require_stable(t[i]).verdict();
    if (!verdict.passed) {
      // Larger steps than the usual one may fail: that they do is what the case finds out.
      if (steps_of_time.at(i) <= usual) judgement.require(false, verdict.reason);
      break;
    }
    largest = steps_of_time.at(i);
  }
  return judgement.set_figure("largest stable dt", largest).verdict();
}

}  // namespace

StabilityCase time_steps() {
  return {.name = "time-steps",
          .summary = "double bubble (N = 16) for 4 units of time with dt from 0.0025 to 0.08",
          .criterion = "energy stays within 1% above the start's and volumes within 2%, up to dt = 0.01 at least",
          .typical_triangles = 1000,
          .runs = runs_of_time_steps,
          .judge = judge_time_steps};
}

}  // namespace foamsim::stability
