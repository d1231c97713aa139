#include "FoamSim/sheet/velocity/pair_sums.h"

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

class PairSumsIn : public testing::TestWithParam<Precision> {};
INSTANTIATE_TEST_SUITE_P(Precisions, PairSumsIn, testing::Values(Precision::doubles, Precision::singles));

TEST_P(PairSumsIn, AreTheSameBitsForAnyNumberOfThreads) {
  const Triangles t = random_triangles(3000);
  PairSums one, two;
  {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
    DirectPairSums(GetParam()).evaluate(t.sources, 0.05, PairTerms::all, one);
  }
  DirectPairSums(GetParam()).evaluate(t.sources, 0.05, PairTerms::all, two);
  EXPECT_EQ(one.potential, two.potential);
  EXPECT_EQ(one.force, two.force);
  EXPECT_EQ(one.velocity, two.velocity);
}

// Of the largest of their kind: what a triangle's neighbours do to it may cancel.
double largest_difference(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double difference = 0, size = 0;
  for (std::size_t t = 0; t < a.size(); ++t) {
    difference = std::max(difference, (a[t] - b[t]).norm());
    size = std::max(size, b[t].norm());
  }
  return difference / size;
}

// Far from the origin, in units that no single could hold.
TEST(PairSums, InSinglesAreThoseInDoublesToAMillionth) {
  constexpr double length = 1e-30, strength = 1e30;
  Triangles t = random_triangles(5000);
  for (std::size_t i = 0; i < t.place.size(); ++i)
    t.sources.set(i, length * (t.place[i] + Vec3(100, 0, 0)), strength * t.strength[i]);
  PairSums doubles, singles, automatic;
  DirectPairSums(Precision::doubles).evaluate(t.sources, 0.05 * length, PairTerms::all, doubles);
  DirectPairSums(Precision::singles).evaluate(t.sources, 0.05 * length, PairTerms::all, singles);
  DirectPairSums(Precision::automatic).evaluate(t.sources, 0.05 * length, PairTerms::all, automatic);
  EXPECT_LT(largest_difference(singles.potential, doubles.potential), 3e-6);
  EXPECT_LT(largest_difference(singles.force, doubles.force), 3e-6);
  EXPECT_LT(largest_difference(singles.velocity, doubles.velocity), 3e-6);
  EXPECT_NE(singles.potential, doubles.potential);
  EXPECT_EQ(automatic.potential, singles.potential);
  const Triangles few = random_triangles(many_triangles - 1);
  DirectPairSums(Precision::automatic).evaluate(few.sources, 0.05, PairTerms::potential, automatic);
  DirectPairSums(Precision::doubles).evaluate(few.sources, 0.05, PairTerms::potential, doubles);
  EXPECT_EQ(automatic.potential, doubles.potential);
}

// Σ γ'·Ψ[γ] = Σ γ·Ψ[γ'], what makes velocities the adjoint of forces, holds to the precision's rounding.
TEST(PairSums, AreSymmetricInSinglesToo) {
  const Triangles t = random_triangles(2000);
  Triangles other = t;
  for (std::size_t i = 0; i < t.place.size(); ++i)
    other.sources.set(i, t.place[i], other.strength[i] = t.strength[(7 * i + 1) % t.place.size()]);
  PairSums of_one, of_other;
  DirectPairSums(Precision::singles).evaluate(t.sources, 0.05, PairTerms::potential, of_one);
  DirectPairSums(Precision::singles).evaluate(other.sources, 0.05, PairTerms::potential, of_other);
  double there = 0, back = 0, scale = 0;
  for (std::size_t i = 0; i < t.place.size(); ++i) {
    there += other.strength[i].dot(of_one.potential[i]);
    back += t.strength[i].dot(of_other.potential[i]);
    scale += t.strength[i].dot(of_one.potential[i]);
  }
  EXPECT_LT(std::abs(there - back), 3e-6 * scale);
}

TEST(PairSums, AskForARegularisation) {
  PairSums sums;
  for (double delta : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(DirectPairSums().evaluate(random_triangles(3).sources, delta, PairTerms::all, sums), base::InputError);
}

}  // namespace
}  // namespace foamsim
