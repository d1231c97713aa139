#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "LosTopos/error.h"
#include "LosTopos/mesh/audit.h"
#include "LosTopos/mesh/measures.h"
#include "LosTopos/shapes/solids.h"
#include "MultiTracker/flows/advect.h"
#include "MultiTracker/flows/enright.h"
#include "MultiTracker/flows/rotation.h"
#include "MultiTracker/scenes/scene.h"

namespace multitracker {
namespace {

using lostopos::SurfaceTracker;
using lostopos::Vec3;
using lostopos::Vertex;

double divergence(const Flow& flow, const Vec3& x, double time) {
  constexpr double h = 1e-5;
  double sum = 0;
  for (int i = 0; i < 3; ++i) {
    const Vec3 step = h * Vec3::Unit(i);
    sum += (flow.velocity(x + step, time) - flow.velocity(x - step, time))[i] / (2 * h);
  }
  return sum;
}

double farthest_after_one_period(const SceneEntry& scene, long steps) {
  SurfaceTracker tracker(scene.surface(2), {.collisions = false, .remeshing = false, .remesh = {}});
  const std::vector<Vec3> start(tracker.mesh().positions().begin(), tracker.mesh().positions().end());
  const auto flow = scene.flow();
  const double dt = flow->period() / static_cast<double>(steps);
  for (long i = 0; i < steps; ++i) advect(tracker, *flow, static_cast<double>(i) * dt, dt);
  double farthest = 0;
  for (Vertex v : tracker.mesh().vertices())
    farthest = std::max(farthest, (tracker.mesh().position(v) - start[v.index()]).norm());
  return farthest;
}

TEST(Flows, AreFreeOfDivergence) {
  for (const SceneEntry& scene : scene_entries())
    for (const Vec3& x : {Vec3(0.2, 0.7, 0.4), Vec3(0.9, 0.1, 0.6), Vec3(0.5, 0.5, 0.3)})
      EXPECT_NEAR(divergence(*scene.flow(), x, 0.4), 0, 1e-8) << scene.name;
}

TEST(Flows, EnrightVanishesOnTheBoxAndTurnsBackAtHalfTime) {
  const EnrightFlow flow;
  EXPECT_NEAR(flow.velocity({0, 0.3, 0.4}, 0.2).norm(), 0, 1e-15);
  const Vec3 x(0.3, 0.6, 0.2);
  EXPECT_GT(flow.velocity(x, 0).norm(), 0.1);
  EXPECT_NEAR((flow.velocity(x, 0.7) + flow.velocity(x, 3 - 0.7)).norm(), 0, 1e-14);
}

TEST(Flows, EverySceneComesBackAtFourthOrder) {
  for (const SceneEntry& scene : scene_entries()) {
    const double coarse = farthest_after_one_period(scene, 40), fine = farthest_after_one_period(scene, 80);
    EXPECT_GT(std::log2(coarse / fine), 3.5) << scene.name;
    EXPECT_LT(fine, 1e-4) << scene.name;
  }
}

TEST(Flows, RotationKeepsShapeAndVolume) {
  const SceneEntry& scene = scene_by_name("rotation");
  SurfaceTracker tracker(scene.surface(2), {.collisions = false, .remeshing = false, .remesh = {}});
  const double volume = lostopos::region_volumes(tracker.mesh()).back().volume;
  const auto flow = scene.flow();
  for (int i = 0; i < 50; ++i) advect(tracker, *flow, 0, flow->period() / 200);
  EXPECT_NEAR(lostopos::region_volumes(tracker.mesh()).back().volume / volume, 1, 1e-6);
  // A quarter turn about (0.5, 0.5) takes (0.5, 0.75) to (0.25, 0.5).
  EXPECT_NEAR((lostopos::surface_centroid(tracker.mesh()) - Vec3(0.25, 0.5, 0.5)).norm(), 0, 1e-6);
  EXPECT_TRUE(lostopos::audit(tracker.mesh()).clean());
}

TEST(Scenes, AnUnknownNameIsAnErrorWithTheNearest) {
  try {
    scene_by_name("enrigt");
    FAIL();
  } catch (const lostopos::InputError& error) {
    EXPECT_NE(std::string(error.what()).find("did you mean 'enright'"), std::string::npos);
  }
}

}  // namespace
}  // namespace multitracker
