// The criteria themselves, on made-up motions: what passes, and that each limit can fail.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "FoamSim/studies/stability/criteria.h"
#include "trajectories.h"

namespace foamsim {
namespace {

using lostopos::Vec3;
using test::quiet_trajectory;

bool passes(const Trajectory& t) {
  return Judgement().require_physics(t).verdict().passed;
}

TEST(PhysicsLimits, PassAMotionInWhichNothingIsLost) {
  EXPECT_TRUE(passes(quiet_trajectory()));
  Trajectory falling = quiet_trajectory();
  for (std::size_t i = 0; i < falling.samples.size(); ++i) falling.samples[i].energy -= static_cast<double>(i);
  EXPECT_TRUE(passes(falling)) << "energy may fall";
}

TEST(PhysicsLimits, FindEveryBreach) {
  auto broken = [](auto&& edit) {
    Trajectory t = quiet_trajectory();
    edit(t);
    return passes(t);
  };
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(broken([](Trajectory& t) { t.samples[3].energy = 16.2; })) << "energy rises";
  EXPECT_FALSE(broken([](Trajectory& t) { t.samples[3].volume_drift_max = 0.03; })) << "volume is lost";
  EXPECT_FALSE(broken([](Trajectory& t) { t.samples[3].impulse = Vec3(0, 0.2, 0); })) << "impulse appears";
  EXPECT_FALSE(broken([](Trajectory& t) { t.samples[2].area = nan; }));
  EXPECT_FALSE(broken([](Trajectory& t) { t.samples[2].centroid.y() = nan; }));
  EXPECT_FALSE(broken([](Trajectory& t) { t.samples[2].volumes[1].volume = INFINITY; }));
  EXPECT_FALSE(broken([](Trajectory& t) { t.error = "step 3: no way on"; }));
  EXPECT_FALSE(broken([](Trajectory& t) { t.defect = "after step 2: two triangles meet"; }));
  EXPECT_FALSE(broken([](Trajectory& t) { t.out_of_time = true; }));
  EXPECT_FALSE(broken([](Trajectory& t) { t.blown_up = true; }));
  EXPECT_FALSE(broken([](Trajectory& t) { t.samples.pop_back(); })) << "it did not go all its way";
}

TEST(PhysicsLimits, RiseIsMeasuredFromTheLeastEnergySoFar) {
  Trajectory t = quiet_trajectory();
  t.samples[1].energy = 16;
  t.samples[2].energy = 12;
  t.samples[3].energy = 14;
  t.samples[4].energy = 13;
  EXPECT_DOUBLE_EQ(physics_figures(t).energy_rise, 2.0 / 16);
  EXPECT_EQ(physics_figures(t).energy_excess, 0);
  EXPECT_TRUE(Judgement().require_stable(t).verdict().passed);
  t.samples[4].energy = 17;
  EXPECT_DOUBLE_EQ(physics_figures(t).energy_excess, 1.0 / 16);
  EXPECT_FALSE(Judgement().require_stable(t).verdict().passed);
}

TEST(PhysicsLimits, OfAMotionThatStartsWithImpulse) {
  Trajectory t = quiet_trajectory();
  for (std::size_t i = 1; i < t.samples.size(); ++i) t.samples[i].impulse = Vec3(5, 0, 0);
  EXPECT_EQ(physics_figures(t).impulse_drift, 0);
}

TEST(JudgementTest, KeepsTheFirstReason) {
  const Verdict verdict = Judgement().require(true, "no").require(false, "first").require(false, "second").verdict();
  EXPECT_FALSE(verdict.passed);
  EXPECT_EQ(verdict.reason, "first");
}

Trajectory transformed(Trajectory t, double scale, const Vec3& offset) {
  for (Metrics& m : t.samples) {
    m.area *= scale * scale;
    m.energy *= std::pow(scale, 5);
    m.impulse *= std::pow(scale, 4);
    m.impulse_scale *= std::pow(scale, 4);
    m.centroid = scale * m.centroid + offset;
    for (auto& volume : m.volumes) volume.volume *= std::pow(scale, 3);
  }
  for (Vec3& x : t.end_positions) x = scale * x + offset;
  return t;
}

TEST(LargestDifference, IsNothingForTheSameMotionElsewhereAndLarger) {
  const Trajectory t = quiet_trajectory();
  const Vec3 offset(3, -4, 12);
  EXPECT_EQ(largest_difference(t, transformed(t, 2, offset), 2, offset), 0);
  EXPECT_GT(largest_difference(t, transformed(t, 2, offset), 2, Vec3::Zero()), 1);
  EXPECT_GT(largest_difference(t, transformed(t, 2, offset), 4, offset), 0.5);
}

TEST(LargestDifference, SeesEveryMeasure) {
  const Trajectory t = quiet_trajectory();
  auto difference = [&t](auto&& edit) {
    Trajectory other = t;
    edit(other);
    return largest_difference(t, other, 1, Vec3::Zero());
  };
  EXPECT_NEAR(difference([](Trajectory& o) { o.samples[2].area *= 1 + 1e-3; }), 1e-3, 1e-5);
  EXPECT_NEAR(difference([](Trajectory& o) { o.samples[2].energy *= 1 + 1e-3; }), 1e-3, 1e-5);
  EXPECT_NEAR(difference([](Trajectory& o) { o.samples[2].volumes[1].volume *= 1 + 1e-3; }), 1e-3, 1e-5);
  EXPECT_NEAR(difference([](Trajectory& o) { o.samples[2].impulse.x() = 2e-3; }), 1e-3, 1e-9);
  EXPECT_NEAR(difference([](Trajectory& o) { o.samples[2].centroid.x() = 2e-3; }), 1e-3, 1e-9);
  EXPECT_NEAR(difference([](Trajectory& o) { o.samples[2].angle_rms_deg = 1e-3; }), 1e-3, 1e-9);
  EXPECT_NEAR(difference([](Trajectory& o) { o.samples[2].triangle_angle_min_deg += 1e-3; }), 1e-3, 1e-9);
  EXPECT_NEAR(difference([](Trajectory& o) { o.end_positions[1].z() = 2e-3; }), 1e-3, 1e-9);
  EXPECT_EQ(difference([](Trajectory& o) { o.samples[2].triangles = 6; }), INFINITY);
  EXPECT_EQ(difference([](Trajectory& o) { o.samples.pop_back(); }), INFINITY);
  EXPECT_EQ(difference([](Trajectory& o) { o.samples[2].energy = NAN; }), INFINITY);
}

}  // namespace
}  // namespace foamsim
