// Velocities of near clusters in single precision, against the sum itself in double.
#include "FoamSim/sheet/velocity/tree/near_velocity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "LosTopos/vec3.h"

namespace foamsim {
namespace {

using lostopos::Vec3;

// Points of a cluster from its middle; δ is the unit of length.
struct Points {
  std::array<std::vector<float>, 6> values;
  std::size_t size;

  Points(std::size_t n, double radius, unsigned seed) : size(n) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> value(-1, 1);
    for (auto& array : values) {
      array.resize(n + tree_lanes);
      std::ranges::generate(array, [&] { return value(random); });
    }
    for (std::size_t axis : {0U, 1U, 2U})
      for (float& x : values[axis]) x *= static_cast<float>(radius / std::sqrt(3.0));
  }

  TreeBodies<float> bodies(std::size_t first, std::size_t count) const {
    return {values[0].data() + first,
            values[1].data() + first,
            values[2].data() + first,
            values[3].data() + first,
            values[4].data() + first,
            values[5].data() + first,
            count};
  }
  TreeBodies<float> bodies() const { return bodies(0, size); }
  Vec3 place(std::size_t i) const { return {values[0][i], values[1][i], values[2][i]}; }
  Vec3 strength(std::size_t i) const { return {values[3][i], values[4][i], values[5][i]}; }
};

struct Sum {
  Vec3 velocity = Vec3::Zero();
  double largest = 0;  // that it could be
};

Sum exact_sum(const Points& targets, std::size_t t, const Points& sources, const Vec3& offset) {
  Sum sum;
  for (std::size_t s = 0; s < sources.size; ++s) {
    const Vec3 apart = targets.place(t) + offset - sources.place(s);
    const double rho = std::sqrt(apart.squaredNorm() + 1);
    sum.velocity += sources.strength(s).cross(apart) / (rho * rho * rho);
    sum.largest += sources.strength(s).norm() / (rho * rho);
  }
  return sum;
}

std::vector<double> velocities(const TreeBodies<float>& targets, const Points& sources, const Vec3& offset) {
  const std::size_t stride = targets.size + 3;
  std::vector<double> out(3 * stride, 0.0);
  add_near_velocities(targets, near_sources(sources.bodies()), {offset.x(), offset.y(), offset.z()}, 1, out.data(),
                      stride);
  return out;
}

class NearVelocity : public testing::TestWithParam<std::array<double, 3>> {};  // radii, and how far apart

TEST_P(NearVelocity, IsTheSum) {
  const auto [target, source, apart] = GetParam();
  ASSERT_TRUE(are_near_enough(apart, target, source, 1));
  const Points targets(77, target, 1), sources(203, source, 2);
  const Vec3 offset = apart * Vec3(2, -1, 2) / 3;
  const std::vector<double> got = velocities(targets.bodies(), sources, offset);
  for (std::size_t t = 0; t < targets.size; ++t) {
    const Sum sum = exact_sum(targets, t, sources, offset);
    const Vec3 value(got[t], got[80 + t], got[160 + t]);
    EXPECT_LT((value - sum.velocity).norm(), 4e-6 * sum.largest) << t;
  }
}

INSTANTIATE_TEST_SUITE_P(Clusters, NearVelocity,
                         testing::Values(std::array{0.0, 0.0, 0.0}, std::array{1.0, 1.0, 0.0},
                                         std::array{8.0, 8.0, 0.0}, std::array{20.0, 20.0, 40.0},
                                         std::array{5.0, 0.1, 50.0}, std::array{3.0, 40.0, 1e4},
                                         std::array{1e3, 1e3, 1e6}, std::array{1.0, 1.0, 1e12}));

TEST(NearClusters, AreRefusedWhereDigitsWouldBeLost) {
  EXPECT_FALSE(are_near_enough(0, 65, 65, 1)) << "a target on a source, far from the middle of both";
  EXPECT_FALSE(are_near_enough(0, 1, 1, 1e-3));
  EXPECT_FALSE(are_near_enough(1e20, 1, 1, 1)) << "squares overflow";
  EXPECT_TRUE(are_near_enough(300, 1, 1, 1e-3)) << "far apart";
}

// Whatever group of the vectors it falls into.
TEST(NearVelocities, OfATargetAreItsOwn) {
  const Points targets(45, 3, 3), sources(130, 3, 4);
  const Vec3 offset(1, 2, 3);
  const std::vector<double> all = velocities(targets.bodies(), sources, offset);
  for (std::size_t t = 0; t < targets.size; ++t) {
    const std::vector<double> one = velocities(targets.bodies(t, 1), sources, offset);
    for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(one[4 * c], all[48 * c + t]) << t;
  }
}

}  // namespace
}  // namespace foamsim
