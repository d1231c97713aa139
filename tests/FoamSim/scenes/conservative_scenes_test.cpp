// Every scene with the conservative dynamics: its energy changes by the work of wires, rods and effects, and by what
// remeshing takes. What dissipates on purpose, diffusion and damping, is left out.
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>

#include "FoamSim/scenes/scene.h"
#include "LosTopos/mesh/audit.h"

namespace foamsim {
namespace {

std::vector<std::string> scenes_with_a_start() {
  std::vector<std::string> names;
  for (const SceneEntry& scene : built_in_scenes())
    if (!scene.mesh_file) names.emplace_back(scene.name);
  return names;
}

Scene without_dissipation(const std::string& name) {
  Scene scene = built_in_scene(name);
  std::vector<std::string> effects = scene.options.words("effects");
  std::erase_if(effects, [](const std::string& effect) { return effect == "diffusion" || effect == "damping"; });
  effects.emplace_back("volumes");
  scene.options.set("effects", effects, "test");
  scene.options.set("dynamics", std::string("conservative"), "test");
  if (name == "foam") scene.options.set("burst_start", 0.1, "test");
  return scene;
}

struct EnergyBalance {
  double before = 0, after = 0, work = 0, lost = 0;  // L⁵/T²
  double error() const { return after - before - work - lost; }
};

// Of the steps behind the first, which may start by remeshing. Energies are those within a step, behind what effects
// put in and before wires move; what the tracker takes is told by the step after it.
EnergyBalance energy_balance(Simulation& simulation, int steps) {
  StepReport report = simulation.step();
  EnergyBalance balance;
  balance.before = report.kinetic_energy + report.potential_energy;
  while (simulation.steps() < steps) {
    balance.work += report.wire_work;
    report = simulation.step();
    balance.work += report.effect_work;
    // What it puts in, the dynamics take back.
    balance.lost += std::min(0.0, report.tracker_surface_energy) + std::min(0.0, report.tracker_kinetic_energy);
  }
  balance.after = report.kinetic_energy + report.potential_energy;
  return balance;
}

class ConservativeScene : public testing::TestWithParam<std::string> {};

TEST_P(ConservativeScene, ChangesItsEnergyByWorkThatIsCounted) {
  Simulation simulation = make_simulation(without_dissipation(GetParam()));
  const EnergyBalance b = energy_balance(simulation, 21);
  const double share = 100 / std::max(b.after, 1e-300);
  std::cout << GetParam() << ": energy " << b.before << " to " << b.after << ", work " << b.work << ", remeshing took "
            << -share * b.lost << "%, unaccounted " << share * b.error() << "%\n";
  EXPECT_LE(std::abs(b.error()), 0.002 * b.after);
  EXPECT_GE(b.lost, -0.1 * b.after);
  const auto report = lostopos::audit(simulation.mesh(), {.closed_regions = false});
  EXPECT_TRUE(report.clean()) << report.text();
}

INSTANTIATE_TEST_SUITE_P(All, ConservativeScene, testing::ValuesIn(scenes_with_a_start()), [](const auto& info) {
  std::string name = info.param;
  std::ranges::replace(name, '-', '_');
  return name;
});

}  // namespace
}  // namespace foamsim
