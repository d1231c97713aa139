// Prescribed flows: what comes back has to be what it was.
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "LosTopos/surface_tracker.h"
#include "tests/MultiTracker/tracking_checks.h"

#ifndef ENRIGHT_SETTINGS
#define ENRIGHT_SETTINGS "resolution=0.03"
#endif

namespace multitracker {
namespace {

using lostopos::Vec3;
using lostopos::Vertex;
using test::start;
using test::step_and_audit;
using test::volume_of;

// Mean and largest distance of the vertices from a sphere, over its radius.
std::pair<double, double> distance_from_sphere(const lostopos::SurfaceMesh& mesh, const Vec3& centre, double radius) {
  double sum = 0, largest = 0;
  for (Vertex v : mesh.vertices()) {
    const double distance = std::abs((mesh.position(v) - centre).norm() - radius) / radius;
    sum += distance;
    largest = std::max(largest, distance);
  }
  return {sum / static_cast<double>(mesh.vertex_count()), largest};
}

TEST(Zalesak, OneTurnKeepsTheVolume) {
  Tracking tracking = start("zalesak", {"period_steps=100"});
  const double before = volume_of(tracking.mesh(), 1), area = tracking.metrics().area;
  for (int i = 0; i < 100; ++i) ASSERT_TRUE(step_and_audit(tracking));
  const double error = volume_of(tracking.mesh(), 1) / before - 1;
  std::cout << "volume error " << 100 * error << "%, area " << 100 * (tracking.metrics().area / area - 1) << "%\n";
  EXPECT_LE(std::abs(error), 5e-3);
}

// Also with remeshing, which finds nothing to do on a body that does not change.
TEST(RigidMotion, TurnsAndShiftsKeepTheShape) {
  Tracking tracking = start("rotation", {"period_steps=100"});
  const double volume = volume_of(tracking.mesh(), 1);
  for (int i = 0; i < 100; ++i) ASSERT_TRUE(step_and_audit(tracking));
  EXPECT_LT(distance_from_sphere(tracking.mesh(), {0.5, 0.75, 0.5}, 0.15).second, 1e-3);
  EXPECT_NEAR(volume_of(tracking.mesh(), 1) / volume, 1, 1e-3);

  const SceneEntry& scene = scene_by_name("rotation");
  const base::OptionSet options = options_of(scene);
  lostopos::SurfaceTracker tracker = start_tracker(scene, options, scene.surface(options));
  const Vec3 shift(0.003, -0.002, 0.001);
  for (int i = 0; i < 100; ++i) {
    std::vector<Vec3> predicted(tracker.mesh().positions().begin(), tracker.mesh().positions().end());
    for (Vec3& x : predicted) x += shift;
    tracker.step(predicted);
  }
  EXPECT_LT(distance_from_sphere(tracker.mesh(), Vec3(0.5, 0.75, 0.5) + 100 * shift, 0.15).second, 1e-3);
  EXPECT_TRUE(lostopos::audit(tracker.mesh()).clean());
}

TEST(Enright, ComesBackAfterAPeriod) {
  Tracking tracking = start("enright", {ENRIGHT_SETTINGS, "subdivisions=4"});
  const double before = volume_of(tracking.mesh(), 1);
  while (tracking.metrics().step < 300) {
    tracking.step();
    const bool look = tracking.metrics().step % 30 == 0;
    ASSERT_EQ(look ? tracking.audit().text() : "clean", "clean");
  }
  const double error = volume_of(tracking.mesh(), 1) / before - 1;
  const auto [mean, largest] = distance_from_sphere(tracking.mesh(), {0.35, 0.35, 0.35}, 0.15);
  std::cout << ENRIGHT_SETTINGS << ": " << tracking.metrics().triangles << " triangles, volume error " << 100 * error
            << "%, distance from the sphere over its radius: mean " << mean << ", largest " << largest << "\n";
  EXPECT_LE(std::abs(error), ENRIGHT_VOLUME_ERROR);
  EXPECT_EQ(lostopos::euler_characteristic(tracking.mesh()), 2);
}

}  // namespace
}  // namespace multitracker
