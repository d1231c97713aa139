// Scenes with films in frames and rings of wire, where the reference program fails: these rest or move on.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "FoamSim/scenes/scene.h"
#include "LosTopos/mesh/audit.h"
#include "LosTopos/mesh/measures.h"

namespace foamsim {
namespace {

using lostopos::Vertex;

Simulation after(const char* name, int steps, const std::vector<std::string>& assignments = {}) {
  Scene scene = built_in_scene(name);
  for (const std::string& assignment : assignments) scene.options.set_assignment(assignment, "test");
  Simulation simulation = make_simulation(scene);
  for (int i = 0; i < steps; ++i) simulation.step();
  const lostopos::AuditReport audit = lostopos::audit(simulation.mesh());
  EXPECT_TRUE(audit.clean()) << name << ": " << audit.text();
  return simulation;
}

double volume(const Simulation& simulation, std::size_t region) {
  for (const auto& [r, v] : lostopos::region_volumes(simulation.mesh()))
    if (r == lostopos::Region(region)) return v;
  return 0;
}

// Of the films: solids are none.
double area(const Simulation& simulation) {
  double sum = 0;
  for (lostopos::Triangle t : simulation.mesh().triangles())
    if (simulation.solid()[t.index()] == 0) sum += lostopos::area(simulation.mesh(), t);
  return sum;
}

// Six films with a point each at t (±1, ±1, ±1) are flat and least at t = 1/6: their area is 4 √2.
TEST(Octahedron, RestsWithTheAreaOfFlatFilms) {
  Simulation simulation = after("octahedron", 150);
  const double rest = area(simulation);
  EXPECT_NEAR(rest / (4 * std::numbers::sqrt2), 1, 2e-3);
  const StepReport report = simulation.step();
  EXPECT_LT(report.kinetic_energy, 1e-5 * report.potential_energy);
  EXPECT_NEAR(area(simulation) / rest, 1, 1e-5);
}

// Volumes stay there, and with them the films' places: it calms down without winning energy.
TEST(Octahedron, CalmsDownWithConservativeDynamics) {
  Scene scene = built_in_scene("octahedron");
  scene.options.set_assignment("dynamics=conservative", "test");
  Simulation simulation = make_simulation(scene);
  const double start = 4 * area(simulation);
  double kinetic_before = 0, kinetic = 0;
  for (int i = 1; i <= 60; ++i) {
    kinetic = simulation.step().kinetic_energy;
    if (i == 20) kinetic_before = kinetic;
    EXPECT_LT(kinetic + 4 * area(simulation), 1.001 * start) << "step " << i;
  }
  EXPECT_LT(kinetic, 0.8 * kinetic_before);
  EXPECT_TRUE(lostopos::audit(simulation.mesh()).clean());
}

TEST(Peanut, MovesWithoutTouchingItsWire) {
  const Simulation simulation = after("peanutbubble", 50);
  EXPECT_NEAR(volume(simulation, 1) / 6.9867, 1, 1e-2);
  std::size_t held = 0;
  for (Vertex v : simulation.mesh().vertices())
    if (lostopos::is_held(simulation.held()[v.index()])) {
      ++held;
      EXPECT_NEAR(simulation.mesh().position(v).x(), 0, 1e-12);
    }
  EXPECT_GE(held, 30U);
}

}  // namespace
}  // namespace foamsim
