// Where the volume of a bubble comes from that a straw blows or a wand drags: from what flows through the rim.
#include <gtest/gtest.h>

#include <iostream>

#include "LosTopos/mesh/measures.h"
#include "tests/FoamSim/constraints/rim_gauge.h"

namespace foamsim {
namespace {

double volume_behind_rim(const Simulation& simulation) {
  return lostopos::region_volumes(simulation.mesh()).at(1).volume;
}

// Volumes, L³.
struct RimBalance {
  double gained = 0;
  double swept = 0;      // by the rim: it enters through the cone, which holds no air back
  double through = 0;    // the rim and away from the cone, of the air
  double held_back = 0;  // by the film's corners at the rim, which go with the wire and not with the air
  double rest() const { return gained - (swept + through - held_back); }
};

// Over 0.2 in steps of dt. `speed`: of the rim against the normal out of the bubble.
RimBalance balance_at_rim(Scene scene, double speed, double dt) {
  scene.options.set("dt", dt, "test");
  test::RimFlow flow;
  Simulation simulation = make_simulation(test::gauged(scene, flow));
  const double start = volume_behind_rim(simulation);
  const double area = test::rim_area(simulation.mesh(), simulation.solid()).x();
  while (simulation.time() < 0.2 - dt / 2) simulation.step();
  const RimBalance b{volume_behind_rim(simulation) - start, area * speed * simulation.time(), flow.through,
                     flow.at_rim + speed * flow.rim_share.x()};
  std::cout << scene.name << " at speed " << speed << ", dt " << dt << ": swept " << b.swept << ", through the rim "
            << b.through << ", held back at it " << b.held_back << ", gained " << b.gained << '\n';
  return b;
}

Scene refined(const char* name, long n, double resolution) {
  Scene scene = built_in_scene(name);
  scene.options.set("n", n, "test");
  scene.options.set("resolution", resolution, "test");
  return scene;
}

Scene dragged(double speed, long n, double resolution) {
  Scene scene = refined("bubblewand", n, resolution);
  scene.options.set("wires", std::vector<std::string>{"held: move " + std::to_string(-speed) + " 0 0"}, "test");
  return scene;
}

// The rim stands still; outside it the jet's air comes back.
TEST(RimBalance, AStrawsBubbleGrowsByWhatIsBlown) {
  for (const double dt : {0.01, 0.0025}) {
    const RimBalance b = balance_at_rim(refined("straw", 24, 0.25), 0, dt);
    EXPECT_GT(b.through, 0.5);
    EXPECT_LT(std::abs(b.rest()), 0.015 * b.through);
  }
}

TEST(RimBalance, AWandGainsWhatItSweepsLessWhatItLoses) {
  for (const double speed : {1.0, 2.0}) {
    const RimBalance b = balance_at_rim(dragged(speed, 12, 0.25), speed, 0.01);
    EXPECT_LT(b.through, 0) << "some air is carried along";
    EXPECT_GT(b.held_back, 0);
    EXPECT_LT(std::abs(b.rest()), 0.005 * b.swept);
  }
}

// It is the films' facets that hold back, those in the row at the rim.
TEST(RimBalance, AWandLosesHalfAtTheRimOnAMeshTwiceAsFine) {
  const RimBalance coarse = balance_at_rim(dragged(2, 12, 0.25), 2, 0.0025);
  const RimBalance fine = balance_at_rim(dragged(2, 24, 0.125), 2, 0.0025);
  EXPECT_LT(std::abs(fine.rest()), 0.005 * fine.swept);
  EXPECT_LT(fine.held_back, 0.6 * coarse.held_back);
}

}  // namespace
}  // namespace foamsim
