#include "FoamSim/conservative/pair_sums.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <Eigen/Geometry>
#include <numbers>
#include <random>

#include "Base/error.h"

namespace foamsim {
namespace {

using lostopos::Vec3;

struct Triangles {
  std::vector<Vec3> place, strength;
  VortexSources sources;
};

Triangles random_triangles(std::size_t n) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> value(-1, 1);
  const auto vector = [&] { return Vec3(value(random), value(random), value(random)); };
  Triangles made;
  made.sources.resize(n);
  for (std::size_t t = 0; t < n; ++t) {
    made.place.push_back(vector());
    made.strength.push_back(vector());
    made.sources.set(t, made.place[t], made.strength[t]);
  }
  return made;
}

// Numbers on both sides of a row's and a lane's end.
class PairSumsOf : public testing::TestWithParam<std::size_t> {};

TEST_P(PairSumsOf, AreThoseOfEveryPairWrittenOut) {
  const Triangles t = random_triangles(GetParam());
  constexpr double delta = 0.1;
  PairSums sums;
  DirectPairSums().evaluate(t.sources, delta, PairTerms::all, sums);
  for (std::size_t i = 0; i < t.place.size(); ++i) {
    Vec3 potential = Vec3::Zero(), force = Vec3::Zero(), velocity = Vec3::Zero();
    for (std::size_t j = 0; j < t.place.size(); ++j) {
      const Vec3 d = t.place[i] - t.place[j];
      const double rho = std::sqrt(d.squaredNorm() + delta * delta);
      potential += t.strength[j] / rho;
      force -= t.strength[i].dot(t.strength[j]) * d / std::pow(rho, 3);
      velocity += t.strength[j].cross(d) / std::pow(rho, 3);
    }
    constexpr double scale = std::numbers::inv_pi / 4;
    EXPECT_LT((sums.potential[i] - scale * potential).norm(), 1e-12 * scale / delta * 100);
    EXPECT_LT((sums.force[i] - scale * force).norm(), 1e-12 * scale / (delta * delta) * 100);
    EXPECT_LT((sums.velocity[i] - scale * velocity).norm(), 1e-12 * scale / (delta * delta) * 100);
  }
  PairSums alone;
  DirectPairSums().evaluate(t.sources, delta, PairTerms::potential, alone);
  EXPECT_EQ(alone.potential, sums.potential) << "to the bit";
  EXPECT_TRUE(alone.velocity.empty());
}

INSTANTIATE_TEST_SUITE_P(Sizes, PairSumsOf, testing::Values(1, 2, 7, 8, 9, 31, 32, 33, 200, 1100));

TEST(PairSums, AreTheSameBitsForAnyNumberOfThreads) {
  const Triangles t = random_triangles(3000);
  PairSums one, two;
  {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
    DirectPairSums().evaluate(t.sources, 0.05, PairTerms::all, one);
  }
  DirectPairSums().evaluate(t.sources, 0.05, PairTerms::all, two);
  EXPECT_EQ(one.potential, two.potential);
  EXPECT_EQ(one.force, two.force);
  EXPECT_EQ(one.velocity, two.velocity);
}

TEST(PairSums, AskForARegularisation) {
  PairSums sums;
  for (double delta : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(DirectPairSums().evaluate(random_triangles(3).sources, delta, PairTerms::all, sums), base::InputError);
}

}  // namespace
}  // namespace foamsim
