#include "FoamSim/effects/growth.h"

#include <gtest/gtest.h>

#include <cmath>

#include "FoamSim/scenes/scene.h"
#include "LosTopos/mesh/measures.h"
#include "LosTopos/shapes/solids.h"

namespace foamsim {
namespace {

using lostopos::Vec3;
using lostopos::Vertex;

TEST(GrowthTest, MovesBothWaysAsItsNormalsSay) {
  const lostopos::SurfaceMesh mesh = lostopos::cube(1);
  SurfaceGeometry geometry;
  geometry.update(mesh);
  const EffectStep step{mesh, geometry, 0, 0.1};
  Growth unit(2, GrowthNormals::unit), weighted(2);
  EXPECT_TRUE(weighted.displaced(step).empty());
  std::vector<Vec3> velocity(mesh.vertex_slots(), Vec3::Zero());
  unit.add_velocity({step, 0, mesh.positions()}, velocity);
  EXPECT_EQ(velocity, std::vector<Vec3>(mesh.vertex_slots(), Vec3::Zero()));
  weighted.add_velocity({step, 0, mesh.positions()}, velocity);
  const std::vector<Vec3> displaced = unit.displaced(step);
  for (Vertex v : mesh.vertices()) {
    // Mean over the triangles, by hand: of a cube's faces all normals are along the axes.
    Vec3 mean = Vec3::Zero();
    for (lostopos::Triangle t : mesh.triangles(v)) mean += lostopos::area_vector(mesh, t).normalized();
    mean /= static_cast<double>(mesh.triangles(v).size());
    EXPECT_LT((displaced[v.index()] - mesh.position(v) - 0.2 * mean).norm(), 1e-14);
    EXPECT_NEAR(velocity[v.index()].norm(), 2, 1e-12);
  }
}

// Scene foaminit against a run of the published program: volume 0.5685 of each sphere at its clock 0.4.
TEST(GrowthTest, GrowsTheSpheresOfFoaminitAsMeasured) {
  Simulation simulation = make_simulation(built_in_scene("foaminit"));
  for (const auto& [region, volume] : lostopos::closed_region_volumes(simulation.mesh()))
    if (region != lostopos::air) {
      EXPECT_NEAR(volume, 0.4573, 1e-4);
    }
  double work = 0;
  while (simulation.time() < 0.2 - 1e-9) work += simulation.step().effect_work;
  for (const auto& [region, volume] : lostopos::closed_region_volumes(simulation.mesh()))
    if (region != lostopos::air) {
      EXPECT_NEAR(volume, 0.5685, 0.01 * 0.5685) << region.index();
    }
  EXPECT_GT(work, 0) << "films have been stretched";
}

}  // namespace
}  // namespace foamsim
