// Spheres that grow until they have pressed each other into a foam.
#include "FoamSim/effects/growth.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "FoamSim/metrics/metrics.h"
#include "FoamSim/scenes/scene.h"
#include "FoamSim/scenes/shapes/solids.h"
#include "LosTopos/mesh/air_side.h"
#include "LosTopos/mesh/audit.h"
#include "tests/FoamSim/film_parts.h"

namespace foamsim {
namespace {

using lostopos::SurfaceMesh;
using lostopos::Vertex;

TEST(GrowthEffect, MovesASphereOutAtTheAskedSpeed) {
  for (const char* integrator : {"euler", "rk4"}) {
    Simulation simulation(icosphere(3), {}, test::parts(std::make_unique<Growth>(0.4), integrator));
    for (int i = 0; i < 50; ++i) simulation.step();
    for (Vertex v : simulation.mesh().vertices())
      EXPECT_NEAR(simulation.mesh().position(v).norm(), 1 + 0.4 * 0.5, 1e-3) << integrator;
  }
}

TEST(GrowthScene, GrowsAFoamWithJunctionsAndACleanAudit) {
  Simulation simulation = make_simulation(built_in_scene("growth"));
  EXPECT_EQ(lostopos::area_by_side(simulation.mesh()).shared, 0);
  while (simulation.time() < 0.8 - 1e-9) {
    simulation.step();
    const lostopos::AuditReport audit = lostopos::audit(simulation.mesh());
    ASSERT_TRUE(audit.clean()) << "step " << simulation.steps() << "\n" << audit.text();
  }
  const SurfaceMesh& mesh = simulation.mesh();
  EXPECT_EQ(lostopos::regions(mesh).size(), 9U) << "eight bubbles and the air";
  EXPECT_GT(lostopos::junction_edge_count(mesh), 100U);
  // Eight cells of a cube have twelve films between neighbours, of about 1 each when they fill their cubes.
  const auto [air_side, shared] = lostopos::area_by_side(mesh);
  EXPECT_GT(shared, 3);
  EXPECT_GT(simulation.topology_totals().snaps, 50U);
}

}  // namespace
}  // namespace foamsim
