#include "FoamSim/metrics/metrics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "FoamSim/metrics/rest_detector.h"
#include "FoamSim/scenes/shapes/double_bubble.h"
#include "FoamSim/scenes/shapes/solids.h"
#include "tests/FoamSim/film_parts.h"
#include "tests/support/sample_meshes.h"

namespace foamsim {
namespace {

using lostopos::air;
using lostopos::Region;
using lostopos::RegionVolume;
using lostopos::SurfaceMesh;
using lostopos::Vec3;
using lostopos::Vertex;

TEST(VolumeDrift, IsTheLargestOfAllRegionsButTheAir) {
  const std::vector<RegionVolume> start{{air, -6}, {Region(1), 2}, {Region(5), 4}};
  EXPECT_EQ(largest_volume_drift(start, start), 0);
  EXPECT_EQ(largest_volume_drift({{air, -7}, {Region(1), 2.5}, {Region(5), 4.5}}, start), 0.25);
  EXPECT_EQ(largest_volume_drift({{air, -5.5}, {Region(1), 2}, {Region(5), 3.5}}, start), 0.125);
}

TEST(VolumeDrift, LeavesOutRegionsThatCameOrVanished) {
  const std::vector<RegionVolume> start{{air, -6}, {Region(1), 2}, {Region(5), 4}};
  EXPECT_EQ(largest_volume_drift({{air, -2}, {Region(1), 2.5}}, start), 0.25) << "region 5 has vanished by design";
  EXPECT_EQ(largest_volume_drift({{air, -2}, {Region(1), 2}, {Region(5), 4}, {Region(6), 1}}, start), 0)
      << "a new region has nothing to compare with";
}

TEST(ClosedRegionVolumes, LeaveOutRegionsThatAnOpenFilmBounds) {
  const SurfaceMesh bubble = lostopos::test::corner_tetrahedron(1);
  const auto closed = closed_region_volumes(bubble);
  ASSERT_EQ(closed.size(), 2U);
  EXPECT_NEAR(closed[1].volume, 1.0 / 6, 1e-15);
  // A film between regions 3 and 4 beside it, with free edges.
  SurfaceMesh mesh = lostopos::test::corner_tetrahedron(1);
  const Vertex a = mesh.add_vertex({5, 0, 0}), b = mesh.add_vertex({6, 0, 0}), c = mesh.add_vertex({5, 1, 0});
  mesh.add_triangle(a, b, c, {Region(3), Region(4)});
  const auto volumes = closed_region_volumes(mesh);
  ASSERT_EQ(volumes.size(), 2U);
  EXPECT_EQ(volumes[1].region, Region(1));
  EXPECT_NEAR(volumes[1].volume, 1.0 / 6, 1e-14);
}

TEST(SmallestTriangleAngle, OfKnownTriangles) {
  EXPECT_NEAR(smallest_triangle_angle(lostopos::test::corner_tetrahedron(7)), 45, 1e-12);
  EXPECT_NEAR(smallest_triangle_angle(tetrahedron(2)), 60, 1e-11);
  SurfaceMesh mesh;
  for (const Vec3& x : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1e-9, 0)}) mesh.add_vertex(x);
  mesh.add_triangle(Vertex(0), Vertex(1), Vertex(2), {Region(1), air});
  EXPECT_NEAR(smallest_triangle_angle(mesh) / (1e-9 * 180 / std::numbers::pi), 1, 1e-6);
}

Simulation double_bubble_simulation(double scale, const Vec3& shift, double dt = 0.01) {
  SurfaceMesh mesh = double_bubble(12);
  for (Vertex v : mesh.vertices()) mesh.set_position(v, scale * mesh.position(v) + shift);
  return {std::move(mesh), {.dt = dt}, test::parts(test::tension())};
}

Metrics after(Simulation simulation, int steps) {
  const auto start = lostopos::region_volumes(simulation.mesh());
  StepReport report;
  for (int i = 0; i < steps; ++i) report = simulation.step();
  return measure(simulation, report, start);
}

TEST(MetricsTest, SayWhatTheSurfaceIs) {
  const Metrics m = after(double_bubble_simulation(1, Vec3::Zero()), 5);
  EXPECT_EQ(m.step, 5);
  EXPECT_DOUBLE_EQ(m.time, 0.05);
  EXPECT_EQ(m.triangles, double_bubble(12).triangle_count());
  EXPECT_EQ(m.vertices, double_bubble(12).vertex_count());
  EXPECT_EQ(m.regions, 3U);
  EXPECT_EQ(m.energy, m.kinetic_energy + m.potential_energy);
  EXPECT_NEAR(m.potential_energy / (4 * m.area), 1, 0.01) << "of the start of the step, the area of its end";
  EXPECT_GT(m.kinetic_energy, 0);
  EXPECT_EQ(m.velocity_evaluations, 1);
  EXPECT_LT(m.centroid.norm(), 1e-12);
}

TEST(MetricsTest, AThousandRadiiFromTheOriginAreTheSame) {
  const Metrics here = after(double_bubble_simulation(1, Vec3::Zero()), 10);
  const Vec3 far(1000, 1000, -1000);
  const Metrics there = after(double_bubble_simulation(1, far), 10);
  // Positions are rounded to 1e-13; curvature divides by the squares of edges, 0.3 long.
  EXPECT_NEAR(there.area, here.area, 1e-9);
  EXPECT_NEAR(there.kinetic_energy, here.kinetic_energy, 1e-9);
  EXPECT_NEAR(there.potential_energy, here.potential_energy, 1e-9);
  EXPECT_NEAR(*there.angle_rms_deg, *here.angle_rms_deg, 1e-8);
  EXPECT_NEAR(*there.angle_outer_mean_deg, *here.angle_outer_mean_deg, 1e-8);
  EXPECT_NEAR(there.volume_drift_max, here.volume_drift_max, 1e-10);
  EXPECT_NEAR(there.triangle_angle_min_deg, here.triangle_angle_min_deg, 1e-8);
  EXPECT_LT((there.centroid - far - here.centroid).norm(), 1e-10);
  EXPECT_LT((there.impulse - here.impulse).norm(), 1e-9);
}

TEST(MetricsTest, ScaleWithTheUnitOfLengthToTheBit) {
  // L' = 4 L; σ in L³/T² stays 1 when T' = 8 T. Then areas go with 16, energies (L⁵/T²) with 4⁵/8² = 16, impulse
  // (L⁴/T) with 4⁴/8 = 32.
  const Metrics one = after(double_bubble_simulation(1, Vec3::Zero(), 0.01), 10);
  const Metrics four = after(double_bubble_simulation(4, Vec3::Zero(), 0.08), 10);
  EXPECT_EQ(four.area, 16 * one.area);
  EXPECT_EQ(four.kinetic_energy, 16 * one.kinetic_energy);
  EXPECT_EQ(four.potential_energy, 16 * one.potential_energy);
  EXPECT_EQ(four.impulse, 32 * one.impulse);
  EXPECT_EQ(four.impulse_scale, 32 * one.impulse_scale);
  EXPECT_EQ(four.centroid, 4 * one.centroid);
  EXPECT_EQ(four.angle_rms_deg, one.angle_rms_deg);
  EXPECT_EQ(four.volume_drift_max, one.volume_drift_max);
  EXPECT_EQ(four.triangle_angle_min_deg, one.triangle_angle_min_deg);
}

TEST(StageTimesTest, AddUpByName) {
  base::StageTimes times;
  times.add("velocity", 1.5);
  times.add("move", 0.25);
  times.add("velocity", 0.5);
  base::StageTimes all;
  all.add(times);
  all.add(times);
  EXPECT_EQ(all.seconds("velocity"), 4);
  EXPECT_EQ(all.seconds("nothing"), 0);
  EXPECT_EQ(all.total(), 4.5);
  EXPECT_EQ(all.stages().front().first, "velocity") << "in the order in which they first ran";
}

bool add(RestDetector& detector, double time, double kinetic, double angle) {
  StepReport report;
  report.kinetic_energy = kinetic;
  report.potential_energy = 100;
  return detector.add(time, report, [angle] { return angle; });
}

TEST(RestDetectorTest, NeedsAWholeQuietWindow) {
  RestDetector detector(1);
  for (int i = 0; i < 10; ++i) EXPECT_FALSE(add(detector, 0.1 * i, 1e-5, 3));
  EXPECT_TRUE(add(detector, 1.05, 1e-5, 3));
}

TEST(RestDetectorTest, MotionStartsTheWindowAgain) {
  RestDetector detector(1);
  for (int i = 0; i < 9; ++i) EXPECT_FALSE(add(detector, 0.1 * i, 1e-5, 3));
  EXPECT_FALSE(add(detector, 0.95, 1e-3, 3)) << "more than a millionth of the potential energy";
  EXPECT_FALSE(add(detector, 1.1, 1e-5, 3));
  EXPECT_FALSE(add(detector, 2.0, 1e-5, 3));
  EXPECT_TRUE(add(detector, 2.15, 1e-5, 3));
}

TEST(RestDetectorTest, SlowlyChangingAnglesAreNotRest) {
  RestDetector detector(1);
  for (int i = 0; i <= 100; ++i) EXPECT_FALSE(add(detector, 0.1 * i, 0, 3 + 0.003 * i)) << i;
}

TEST(RestDetectorTest, EnergyThatIsNoNumberIsNotRest) {
  RestDetector detector(1);
  for (int i = 0; i <= 30; ++i) EXPECT_FALSE(add(detector, 0.1 * i, std::numeric_limits<double>::quiet_NaN(), 3)) << i;
}

TEST(CharacteristicTime, IsThatOfTheMeanBubble) {
  const double ball = 4 * std::numbers::pi / 3;
  EXPECT_NEAR(characteristic_time({{air, -9 * ball}, {Region(1), 8 * ball}, {Region(2), 0}}, 1), 2, 1e-12);
  EXPECT_NEAR(characteristic_time({{air, -ball}, {Region(1), ball}}, 4), 0.5, 1e-12);
  EXPECT_EQ(characteristic_time({{air, 0}}, 1), 0);
  EXPECT_EQ(characteristic_time({{air, -1}, {Region(1), 1}}, 0), 0);
}

TEST(RestDetectorTest, NeverFindsRestWithoutAWindow) {
  // Films in a frame have no bubble, and so no characteristic time.
  RestDetector detector(characteristic_time({}, 1));
  for (int i = 0; i < 5; ++i) EXPECT_FALSE(add(detector, i, 0, 3));
}

}  // namespace
}  // namespace foamsim
