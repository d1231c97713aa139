// dt = auto: the step that the conservative dynamics choose.

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "Base/error.h"
#include "FoamSim/scenes/methods.h"
#include "FoamSim/scenes/scene.h"

namespace foamsim {
namespace {

Scene automatic(const std::string& name, std::initializer_list<const char*> assignments) {
  Scene scene = built_in_scene(name);
  choose_method(scene.options, conservative_method, "test");
  scene.options.set_text("dt", "auto", "test");
  for (const char* assignment : assignments) scene.options.set_assignment(assignment, "test");
  return scene;
}

double chosen(const std::string& name, std::initializer_list<const char*> assignments) {
  return make_simulation(automatic(name, assignments)).options().dt;
}

std::string refusal(const Scene& scene) {
  try {
    make_simulation(scene);
  } catch (const base::InputError& error) {
    return error.what();
  }
  return "none";
}

// Capillary waves: ω² = σ k³ to within a factor, so that a step is as h^1.5 and as σ^−½; chosen to two digits.
TEST(StepLength, GrowsAsCapillaryWavesAsk) {
  EXPECT_NEAR(std::log2(chosen("doublebubble", {"n=16"}) / chosen("doublebubble", {"n=32"})), 1.5, 0.25);
  EXPECT_NEAR(chosen("mode", {"n=3"}) / chosen("mode", {"n=3", "sigma=4"}), 2, 0.1);
}

TEST(StepLength, IsShortEnoughForEverySceneAndNoShorterThanAThirdOfThat) {
  for (const char* name : {"mode", "cube", "doublebubble", "headon", "triplejunction-frame", "quadjunction-frame"}) {
    Simulation simulation = make_simulation(automatic(name, {}));
    const StepReport report = simulation.step();
    EXPECT_LE(simulation.options().dt, report.stable_dt) << name;
    EXPECT_GT(simulation.options().dt, 0.33 * report.stable_dt) << name;
  }
}

TEST(StepLength, KeepsEnergyOfAFreelySwingingDoubleBubble) {
  Simulation simulation = make_simulation(automatic("doublebubble", {"n=16", "viscosity=0"}));
  double first = 0, least = 1e300, rise = 0;
  while (simulation.time() < 1.5) {
    const StepReport report = simulation.step();
    const double energy = report.kinetic_energy + report.potential_energy;
    if (first == 0) first = energy;
    least = std::min(least, energy);
    rise = std::max(rise, energy - least);
  }
  EXPECT_LT(rise, 2e-3 * first);
}

TEST(StepLength, IsPartOfTheStateAndNotChosenAgain) {
  const Scene scene = automatic("doublebubble", {"n=12"});
  Simulation whole = make_simulation(scene);
  for (int i = 0; i < 20; ++i) whole.step();
  const SimulationState state = whole.state();
  Simulation resumed = make_simulation(scene, lostopos::SurfaceMesh::from_state(state.tracker), whole.resolution(), {});
  resumed.restore(simulation_state_from_json(nlohmann::json::from_cbor(nlohmann::json::to_cbor(to_json(state)))));
  EXPECT_EQ(resumed.options().dt, whole.options().dt);
  EXPECT_EQ(resumed.time(), whole.time());
}

TEST(StepLength, IsRefusedWhereNothingTellsIt) {
  Scene sheet = built_in_scene("doublebubble");
  sheet.options.set_text("dt", "auto", "test");
  EXPECT_NE(refusal(sheet).find("dynamics=conservative"), std::string::npos) << refusal(sheet);
  const Scene slack = automatic("doublebubble", {"sigma=0"});
  EXPECT_NE(refusal(slack).find("sigma > 0"), std::string::npos) << refusal(slack);
}

// A bubble swinging in its second mode.
class EverySteppingOf : public testing::TestWithParam<const char*> {
 protected:
  static StepReport last_report(double viscosity, const char* dt) {
    const std::string stepping = std::string("stepping=") + GetParam(), eta = "viscosity=" + std::to_string(viscosity),
                      step = std::string("dt=") + dt;
    Scene scene = automatic("mode", {"n=2", "mode=2", "amplitude=0.2", stepping.c_str(), eta.c_str(), step.c_str()});
    Simulation simulation = make_simulation(scene);
    StepReport report;
    while (simulation.time() < 0.5) report = simulation.step();
    return report;
  }
};

TEST_P(EverySteppingOf, IsDampedByViscosity) {
  const auto energy = [](const StepReport& report) { return report.kinetic_energy + report.potential_energy; };
  const double free = energy(last_report(0, "0.02")), damped = energy(last_report(0.1, "0.02"));
  EXPECT_LT(damped, free - 0.01);
  EXPECT_GT(last_report(0.1, "0.02").viscosity_iterations, 0);
}

TEST_P(EverySteppingOf, SplitsStepsThatAreTooLong) {
  const StepReport report = last_report(0, "0.25");
  EXPECT_LT(report.stable_dt, 0.25);
  EXPECT_GE(report.substeps, std::floor(0.25 / report.stable_dt));
  if (GetParam() == std::string("midpoint")) {
    EXPECT_GT(report.midpoint_rounds, 1);
  } else {
    EXPECT_EQ(report.midpoint_rounds, 0);
  }
}

INSTANTIATE_TEST_SUITE_P(Conservative, EverySteppingOf, testing::Values("kick-drift", "midpoint", "rk4"),
                         [](const auto& info) { return info.index == 0 ? std::string("kick_drift") : info.param; });

}  // namespace
}  // namespace foamsim
