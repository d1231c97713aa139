// Films without air come to rest where their energy is least.
#include "FoamSim/dynamics/relaxation.h"

#include <gtest/gtest.h>

#include "Base/error.h"
#include "FoamSim/scenes/scene.h"
#include "FoamSim/scenes/shapes/double_bubble_equilibrium.h"
#include "LosTopos/mesh/audit.h"
#include "LosTopos/mesh/measures.h"

namespace foamsim {
namespace {

Scene relaxing(const char* name, std::initializer_list<std::pair<const char*, base::OptionValue>> options) {
  Scene scene = built_in_scene(name);
  scene.options.set("dynamics", std::string("relaxation"), "test");
  scene.options.set_text("dt", "auto", "test");
  for (const auto& [key, value] : options) scene.options.set(key, value, "test");
  return scene;
}

double energy_after(Simulation& simulation, int steps) {
  double energy = simulation.potential_energy();
  for (int i = 0; i < steps; ++i) {
    const StepReport report = simulation.step();
    EXPECT_LE(simulation.potential_energy(), energy + report.remesh_energy + report.topology_energy + 1e-9 * energy)
        << i;
    energy = simulation.potential_energy();
  }
  return energy;
}

TEST(Relaxation, MakesADoubleBubbleOfLeastArea) {
  Simulation simulation = make_simulation(relaxing("doublebubble", {{"n", 16L}}));
  const auto volumes = lostopos::closed_region_volumes(simulation.mesh());
  const DoubleBubbleEquilibrium exact = double_bubble_equilibrium(volumes[1].volume, volumes[2].volume);
  const double start = lostopos::total_area(simulation.mesh());
  energy_after(simulation, 60);
  const double area = lostopos::total_area(simulation.mesh());
  EXPECT_GT(start, 1.01 * exact.total_area());
  EXPECT_NEAR(area, exact.total_area(), 0.004 * exact.total_area());  // that of its facets
  const auto after = lostopos::closed_region_volumes(simulation.mesh());
  for (std::size_t r = 1; r < 3; ++r) EXPECT_NEAR(after[r].volume, volumes[r].volume, 1e-6 * volumes[r].volume);
  EXPECT_EQ(lostopos::audit(simulation.mesh()).text(), "clean");
}

// A Plateau vertex in a frame: six flat films, whose area is known.
TEST(Relaxation, EndsFilmsAtWhatHoldsThem) {
  Simulation simulation = make_simulation(relaxing("quadjunction-frame", {{"n", 4L}}));
  std::vector<lostopos::Vec3> held;
  for (lostopos::Vertex v : simulation.mesh().vertices())
    if (lostopos::is_held(simulation.held()[v.index()])) held.push_back(simulation.mesh().position(v));
  energy_after(simulation, 60);
  EXPECT_NEAR(lostopos::total_area(simulation.mesh()), 2 * std::sqrt(2.0), 2e-3);
  std::size_t i = 0;
  for (lostopos::Vertex v : simulation.mesh().vertices())
    if (lostopos::is_held(simulation.held()[v.index()])) {
      ASSERT_LT(i, held.size());
      EXPECT_EQ(simulation.mesh().position(v), held[i++]);
    }
  EXPECT_GT(i, 0U);
}

TEST(Relaxation, HasNoAir) {
  for (const char* effects : {"surface_tension,diffusion", "surface_tension,damping"}) {
    Scene scene = relaxing("doublebubble", {});
    scene.options.set_assignment(std::string("effects=") + effects, "test");
    EXPECT_THROW(validate(scene), base::InputError) << effects;
  }
  Scene scene = relaxing("doublebubble", {});
  scene.options.set_assignment("velocity=tree", "test");
  EXPECT_THROW(validate(scene), base::InputError);
}

TEST(Relaxation, NeedsTensionForItsStep) {
  try {
    make_simulation(relaxing("doublebubble", {{"sigma", 0.0}}));
    ADD_FAILURE();
  } catch (const base::InputError& error) {
    EXPECT_NE(std::string(error.what()).find("films under tension"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace foamsim
