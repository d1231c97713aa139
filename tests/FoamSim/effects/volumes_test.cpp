#include "FoamSim/effects/volumes.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

#include "FoamSim/scenes/shapes/double_bubble.h"
#include "LosTopos/mesh/measures.h"
#include "LosTopos/shapes/solids.h"

namespace foamsim {
namespace {

using lostopos::Region;
using lostopos::SurfaceMesh;
using lostopos::Vec3;
using lostopos::Vertex;

// Of a region with the vertices at other positions.
double volume(const SurfaceMesh& mesh, std::span<const Vec3> x, Region region) {
  double sum = 0;
  for (lostopos::Triangle t : mesh.triangles()) {
    const auto [a, b, c] = mesh.vertices(t);
    const double part = x[a.index()].dot(x[b.index()].cross(x[c.index()])) / 6;
    if (mesh.labels(t).p == region) sum += part;
    if (mesh.labels(t).q == region) sum -= part;
  }
  return sum;
}

TEST(Volumes, BringsEveryBubbleBack) {
  SurfaceMesh mesh = double_bubble(12);
  SurfaceGeometry geometry;
  geometry.update(mesh);
  Volumes volumes;
  volumes.attach(mesh);
  const EffectStep step{mesh, geometry, 0, 0.1};
  std::vector<Vec3> x(mesh.positions().begin(), mesh.positions().end());
  const double left = volume(mesh, x, Region(1)), right = volume(mesh, x, Region(2));
  for (Vec3& each : x) each *= each.x() > 0 ? 1.01 : 0.995;
  const std::vector<Vec3> before = x;
  volumes.move_vertices({step, 0.1, x}, x);
  EXPECT_NEAR(volume(mesh, x, Region(1)), left, 1e-6 * left);
  EXPECT_NEAR(volume(mesh, x, Region(2)), right, 1e-6 * right);
  double farthest = 0;
  for (std::size_t v = 0; v < x.size(); ++v) farthest = std::max(farthest, (x[v] - before[v]).norm());
  EXPECT_LT(farthest, 0.03);
}

TEST(Volumes, FollowsWhatOtherEffectsBlowIn) {
  SurfaceMesh mesh = lostopos::icosphere(2);
  SurfaceGeometry geometry;
  geometry.update(mesh);
  Volumes volumes;
  volumes.attach(mesh);
  const EffectStep step{mesh, geometry, 0, 0.01};
  std::vector<Vec3> x(mesh.positions().begin(), mesh.positions().end());
  volumes.velocity_added({step, 0, x}, x);  // a speed of 1 outwards
  const double start = volume(mesh, x, Region(1));
  volumes.move_vertices({step, 0.01, x}, x);
  EXPECT_NEAR(volume(mesh, x, Region(1)) / start, 1 + 0.01 * 3, 1e-6) << "dV = 3 V dt for a velocity x";
}

TEST(Volumes, LeavesHeldVerticesAndStagesOnTheWayAlone) {
  SurfaceMesh mesh = lostopos::icosphere(1);
  SurfaceGeometry geometry;
  geometry.update(mesh);
  Volumes volumes;
  volumes.attach(mesh);
  std::vector<lostopos::Hold> held(mesh.vertex_slots(), lostopos::Hold::none);
  held[3] = lostopos::Hold::all;
  const EffectStep step{mesh, geometry, 0, 0.1, held};
  std::vector<Vec3> x(mesh.positions().begin(), mesh.positions().end());
  for (Vec3& each : x) each *= 1.01;
  const std::vector<Vec3> before = x;
  volumes.move_vertices({step, 0.05, x}, x);
  EXPECT_EQ(x, before);
  volumes.move_vertices({step, 0.1, x}, x);
  EXPECT_EQ(x[3], before[3]);
  EXPECT_NE(x[4], before[4]);
}

TEST(Volumes, RemembersWhatItWants) {
  SurfaceMesh mesh = double_bubble(8);
  Volumes volumes, other;
  volumes.attach(mesh);
  other.restore(volumes.state());
  EXPECT_EQ(other.state(), volumes.state());
}

}  // namespace
}  // namespace foamsim
