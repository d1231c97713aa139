// A film between two rings that are pulled apart slowly is a catenoid, until there is none.
#include <gtest/gtest.h>

#include <cmath>

#include "FoamSim/scenes/scene.h"

namespace foamsim {
namespace {

using lostopos::Vertex;

Scene rings(const char* wires) {
  Scene scene = built_in_scene("tworingspinching");
  const std::string pull = std::string("wires=") + wires;
  for (const std::string& assignment :
       {std::string("constraints=wire"), pull, std::string("n=48"), std::string("resolution=0.075")})
    scene.options.set_assignment(assignment, "test");
  return scene;
}

double distance_of_rings(const Simulation& simulation) {
  // The tips of the cones are 2 farther apart.
  double least = 0, most = 0;
  for (Vertex v : simulation.mesh().vertices()) {
    least = std::min(least, simulation.mesh().position(v).x());
    most = std::max(most, simulation.mesh().position(v).x());
  }
  return most - least - 2;
}

// Area of the catenoid r(x) = c cosh(x/c) between rings of radius 0.5 that are d apart, the stable one.
double catenoid_area(double d) {
  double c = 0.5;
  for (int i = 0; i < 200; ++i) c = 0.5 / std::cosh(d / (2 * c));
  return 3.14159265358979 * c * (d + c * std::sinh(d / c));
}

TEST(Catenoid, IsFollowedAndPinchesWhereThereIsNone) {
  // Fast to where the rings are 0.604 apart, then at a twentieth of the scene's speed.
  Simulation start = make_simulation(rings("held: pull 0.08"));
  for (int i = 0; i < 190; ++i) start.step();
  const SimulationState state = start.state();
  Simulation simulation = make_simulation(rings("held: pull 0.004"), lostopos::SurfaceMesh::from_state(state.tracker),
                                          start.resolution(), {});
  simulation.restore(state);
  const double begun = distance_of_rings(simulation);
  EXPECT_NEAR(begun, 0.604, 1e-9);
  const auto parted = [&] { return simulation.topology_totals().separations > 0; };
  for (int i = 0; i < 1500 && !parted(); ++i) {
    simulation.step();
    if (i == 400) {
      const double d = distance_of_rings(simulation);
      EXPECT_NEAR(simulation.geometry().total_area(), catenoid_area(d), 0.01 * catenoid_area(d));
    }
  }
  ASSERT_TRUE(parted());
  const double diameter = 1, last = 0.6627 * diameter;
  RecordProperty("distance", std::to_string(distance_of_rings(simulation)));
  EXPECT_NEAR(distance_of_rings(simulation), last, 0.03 * last);
}

}  // namespace
}  // namespace foamsim
