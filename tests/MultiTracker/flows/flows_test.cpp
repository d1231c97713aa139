#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <memory>

#include "LosTopos/mesh/audit.h"
#include "LosTopos/mesh/measures.h"
#include "LosTopos/shapes/solids.h"
#include "MultiTracker/flows/advect.h"
#include "MultiTracker/flows/curl_noise.h"
#include "MultiTracker/flows/enright.h"
#include "MultiTracker/flows/rotation.h"

namespace multitracker {
namespace {

using lostopos::SurfaceMesh;
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

struct Case {
  const char* name;
  std::unique_ptr<Flow> flow;
};

std::vector<Case> velocity_fields() {
  std::vector<Case> all;
  all.push_back({"enright", std::make_unique<EnrightFlow>()});
  all.push_back({"rotation", std::make_unique<RotationFlow>(Vec3(0.5, 0.5, 0.5))});
  all.push_back({"curl noise", std::make_unique<CurlNoiseFlow>(7, 0.5, 0.4)});
  return all;
}

SurfaceMesh sphere() {
  SurfaceMesh mesh = lostopos::icosphere(2, 0.15);
  for (Vertex v : mesh.vertices()) mesh.set_position(v, mesh.position(v) + Vec3(0.5, 0.75, 0.5));
  return mesh;
}

SurfaceTracker plain_tracker() {
  lostopos::TrackerOptions options;
  options.collisions = options.remeshing = false;
  return SurfaceTracker(sphere(), options);
}

double farthest_after_one_period(const Flow& flow, long steps) {
  SurfaceTracker tracker = plain_tracker();
  const std::vector<Vec3> start(tracker.mesh().positions().begin(), tracker.mesh().positions().end());
  const double dt = flow.period() / static_cast<double>(steps);
  for (long i = 0; i < steps; ++i) advect(tracker, flow, static_cast<double>(i) * dt, dt);
  double farthest = 0;
  for (Vertex v : tracker.mesh().vertices())
    farthest = std::max(farthest, (tracker.mesh().position(v) - start[v.index()]).norm());
  return farthest;
}

TEST(Flows, AreFreeOfDivergence) {
  for (const Case& c : velocity_fields())
    for (const Vec3& x : {Vec3(0.2, 0.7, 0.4), Vec3(0.9, 0.1, 0.6), Vec3(0.5, 0.5, 0.3)})
      EXPECT_NEAR(divergence(*c.flow, x, 0.4), 0, 1e-6) << c.name;
}

TEST(Flows, CurlNoiseHasItsSpeedAndItsSeed) {
  const CurlNoiseFlow flow(7, 0.5, 0.4), same(7, 0.5, 0.4), other(8, 0.5, 0.4);
  double sum = 0;
  constexpr int n = 20;
  for (int i = 0; i < n * n * n; ++i) {
    const int row = i / n % n, layer = i / (n * n);
    const Vec3 x = 4.0 / n * Vec3(i % n, row, layer);
    EXPECT_EQ(flow.velocity(x, 0), same.velocity(x, 0));
    sum += flow.velocity(x, 0).squaredNorm() / (n * n * n);
  }
  EXPECT_NEAR(std::sqrt(sum), 0.5, 0.05);
  EXPECT_GT((flow.velocity(Vec3::Ones(), 0) - other.velocity(Vec3::Ones(), 0)).norm(), 0.01);
}

TEST(Flows, EnrightVanishesOnTheBoxAndTurnsBackAtHalfTime) {
  const EnrightFlow flow;
  EXPECT_NEAR(flow.velocity({0, 0.3, 0.4}, 0.2).norm(), 0, 1e-15);
  const Vec3 x(0.3, 0.6, 0.2);
  EXPECT_GT(flow.velocity(x, 0).norm(), 0.1);
  EXPECT_NEAR((flow.velocity(x, 0.7) + flow.velocity(x, 3 - 0.7)).norm(), 0, 1e-14);
}

TEST(Flows, ComeBackAfterAPeriodAtFourthOrder) {
  for (const Case& c : velocity_fields()) {
    if (!std::isfinite(c.flow->period())) continue;
    const double coarse = farthest_after_one_period(*c.flow, 40), fine = farthest_after_one_period(*c.flow, 80);
    EXPECT_GT(std::log2(coarse / fine), 3.5) << c.name;
    EXPECT_LT(fine, 1e-4) << c.name;
  }
}

TEST(Flows, RotationKeepsShapeAndVolume) {
  const RotationFlow flow(Vec3(0.5, 0.5, 0.5));
  SurfaceTracker tracker = plain_tracker();
  const double volume = lostopos::region_volumes(tracker.mesh()).back().volume;
  for (int i = 0; i < 50; ++i) advect(tracker, flow, 0, flow.period() / 200);
  EXPECT_NEAR(lostopos::region_volumes(tracker.mesh()).back().volume / volume, 1, 1e-6);
  // A quarter turn about (0.5, 0.5) takes (0.5, 0.75) to (0.25, 0.5).
  EXPECT_NEAR((lostopos::surface_centroid(tracker.mesh()) - Vec3(0.25, 0.5, 0.5)).norm(), 0, 1e-6);
  EXPECT_TRUE(lostopos::audit(tracker.mesh()).clean());
}

}  // namespace
}  // namespace multitracker
