// Scenes in which nothing is held: what is in balance stands still, the rest moves as measured of the reference
// program.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "FoamSim/scenes/scene.h"
#include "LosTopos/mesh/measures.h"

namespace foamsim {
namespace {

using lostopos::Vertex;

// Of one pair over the surface; what all vertices have in common drives nothing.
double largest_difference_of_circulation(const Simulation& simulation) {
  std::map<RegionPair, std::pair<double, double>> range;
  for (Vertex v : simulation.mesh().vertices())
    for (const auto& [pair, value] : simulation.circulation().at(v)) {
      auto& [least, most] = range.try_emplace(pair, value, value).first->second;
      least = std::min(least, value);
      most = std::max(most, value);
    }
  double largest = 0;
  for (const auto& [pair, ends] : range) largest = std::max(largest, ends.second - ends.first);
  return largest;
}

class StandingScene : public testing::TestWithParam<const char*> {};

TEST_P(StandingScene, StandsStillFor20Steps) {
  Simulation simulation = make_simulation(built_in_scene(GetParam()));
  const double area = lostopos::total_area(simulation.mesh());
  for (int i = 0; i < 20; ++i) simulation.step();
  EXPECT_NEAR(lostopos::total_area(simulation.mesh()) / area, 1, 1e-12);
  EXPECT_LT(largest_difference_of_circulation(simulation), 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Scenes, StandingScene, testing::Values("barrel", "triplejunction"),
                         [](const auto& scene) { return std::string(scene.param); });

// 16 rings and segments, the mesh as it is, no diffusion; printed to all of its digits at the clock 0.4.
TEST(DoubleBubble, HasTheAreaThatTheReferenceHas) {
  Scene scene = built_in_scene("doublebubble");
  for (const char* assignment : {"n=16", "effects=surface_tension", "resolution_mean=triangle-sides",
                                 "remeshing.enabled=false", "topology.enabled=false"})
    scene.options.set_assignment(assignment, "test");
  Simulation simulation = make_simulation(scene);
  for (int i = 0; i < 20; ++i) simulation.step();
  EXPECT_NEAR(lostopos::total_area(simulation.mesh()), 24.012322, 1e-6);
}

TEST(QuadJunction, LosesTheAreaThatTheReferenceLoses) {
  Simulation simulation = make_simulation(built_in_scene("quadjunction"));
  for (int i = 0; i < 20; ++i) simulation.step();
  EXPECT_NEAR(lostopos::total_area(simulation.mesh()) / 8.9656, 1, 3e-3);
}

TEST(Foaminit, GrowsAsTheReferenceDoes) {
  Simulation simulation = make_simulation(built_in_scene("foaminit"));
  for (int i = 0; i < 20; ++i) simulation.step();
  for (const auto& [region, volume] : lostopos::region_volumes(simulation.mesh()))
    if (region != lostopos::air) {
      EXPECT_NEAR(volume / 0.5685, 1, 0.01);
    }
}

TEST(TwoBubblesScene, MeetWhileTheyBecomeRound) {
  Simulation simulation = make_simulation(built_in_scene("twobubbles"));
  EXPECT_EQ(lostopos::junction_edge_count(simulation.mesh()), 0U);
  while (lostopos::junction_edge_count(simulation.mesh()) == 0 && simulation.time() < 2) simulation.step();
  EXPECT_LT(simulation.time(), 1) << "a quarter of the lowest mode's period";
  EXPECT_GT(lostopos::junction_edge_count(simulation.mesh()), 3U);
}

}  // namespace
}  // namespace foamsim
