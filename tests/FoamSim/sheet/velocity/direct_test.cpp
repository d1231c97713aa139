// The direct sum against a long double loop, and its promises on bits, scales and coincident points.
#include "FoamSim/sheet/velocity/direct.h"

#include <gtest/gtest.h>
#include <hwy/targets.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "tests/support/biot_savart_oracle.h"

namespace foamsim {
namespace {

using lostopos::Vec3;

struct Problem {
  VortexSources sources;
  std::vector<Vec3> targets;
};

Problem random_problem(std::size_t sources, std::size_t targets, unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  const auto vector = [&] {
    const double x = normal(random);
    const double y = normal(random);
    return Vec3(x, y, normal(random));
  };
  Problem problem;
  problem.sources.resize(sources);
  for (std::size_t t = 0; t < sources; ++t) {
    const Vec3 point = vector();
    problem.sources.set(t, point, vector());
  }
  for (std::size_t i = 0; i < targets; ++i) problem.targets.push_back(vector());
  return problem;
}

std::vector<Vec3> solve(const Problem& problem, double delta) {
  std::vector<Vec3> out(problem.targets.size());
  DirectBiotSavart().velocities(problem.sources, problem.targets, delta, out);
  return out;
}

// Comparing bits, not values, so that −0 and NaN count too.
std::vector<std::uint64_t> bits(const std::vector<Vec3>& velocities) {
  std::vector<std::uint64_t> result;
  for (const Vec3& u : velocities) {
    for (int axis = 0; axis < 3; ++axis) result.push_back(std::bit_cast<std::uint64_t>(u[axis]));
  }
  return result;
}

// Makes Highway choose one instruction set until the end of the scope.
class InstructionSet {
 public:
  explicit InstructionSet(std::int64_t target) { choose(target); }
  ~InstructionSet() { choose(0); }
  InstructionSet(const InstructionSet&) = delete;
  InstructionSet& operator=(const InstructionSet&) = delete;

 private:
  static void choose(std::int64_t target) {
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  }
};

void expect_accurate(const Problem& problem, double delta) {
  const auto exact = test::biot_savart_oracle(problem.sources, problem.targets, delta);
  const auto computed = solve(problem, delta);
  long double worst = 0;
  long double largest = 0;
  for (std::size_t i = 0; i < computed.size(); ++i) {
    const long double error = (computed[i].cast<long double>() - exact[i].velocity).norm();
    ASSERT_LE(error, 1e-13L * exact[i].term_sum) << "target " << i;
    worst = std::max(worst, error);
    largest = std::max(largest, exact[i].velocity.norm());
  }
  EXPECT_LE(worst, 1e-12L * largest);
}

std::string name_of(const testing::TestParamInfo<std::int64_t>& info) {
  return hwy::TargetName(info.param);
}

// Every instruction set that was compiled and that this machine has.
class EveryInstructionSet : public testing::TestWithParam<std::int64_t> {
 protected:
  InstructionSet chosen_{GetParam()};
};

INSTANTIATE_TEST_SUITE_P(Direct, EveryInstructionSet, testing::ValuesIn(hwy::SupportedAndGeneratedTargets()), name_of);

TEST_P(EveryInstructionSet, IsTheOneInUse) {
  EXPECT_EQ(DirectBiotSavart::simd_target(), hwy::TargetName(GetParam()));
}

TEST_P(EveryInstructionSet, AgreesWithLongDoubleLoop) {
  for (const double delta : {0.0, 1e-12, 1e-3, 0.5, 30.0}) {
    for (const std::size_t sources : {0, 1, 2, 7, 255, 257, 1003}) {
      SCOPED_TRACE("delta " + std::to_string(delta) + ", sources " + std::to_string(sources));
      expect_accurate(random_problem(sources, 101, 5), delta);
    }
  }
  for (std::size_t targets = 0; targets <= 70; ++targets) {
    SCOPED_TRACE("targets " + std::to_string(targets));
    expect_accurate(random_problem(33, targets, 6), 0.1);
  }
}

TEST_P(EveryInstructionSet, GivesTheBitsOfTheBestOne) {
  const Problem problem = random_problem(1003, 101, 7);
  const auto here = bits(solve(problem, 1e-2));
  const InstructionSet best(0);
  EXPECT_EQ(here, bits(solve(problem, 1e-2)));
}

TEST(Direct, ManySources) {
  expect_accurate(random_problem(50'001, 9, 8), 1e-2);
}

TEST(Direct, OneSourceByHand) {
  VortexSources sources;
  sources.resize(1);
  sources.set(0, Vec3(1, 1, 1), Vec3(0, 0, 4 * std::numbers::pi));
  const auto u = solve({sources, {Vec3(3, 1, 1), Vec3(1, 1, 9)}}, 0);
  EXPECT_NEAR(u[0].x(), 0, 1e-16);
  EXPECT_NEAR(u[0].y(), 0.25, 1e-15);  // counter-clockwise about the strength
  EXPECT_NEAR(u[0].z(), 0, 1e-16);
  EXPECT_EQ(u[1], Vec3(0, 0, 0));
}

TEST(Direct, SameBitsForAnyNumberOfThreadsAndInEveryRun) {
  const Problem problem = random_problem(1003, 2017, 9);
  const auto first = bits(solve(problem, 1e-2));
  EXPECT_EQ(first, bits(solve(problem, 1e-2)));
  for (const std::size_t threads : {1, 2, 3}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    EXPECT_EQ(first, bits(solve(problem, 1e-2))) << threads << " threads";
  }
}

TEST(Direct, TargetAloneGetsTheBitsItGetsAmongOthers) {
  Problem problem = random_problem(1003, 45, 10);
  const auto together = solve(problem, 1e-2);
  const auto targets = problem.targets;
  for (std::size_t i = 0; i < targets.size(); ++i) {
    problem.targets = {targets[i]};
    EXPECT_EQ(bits({together[i]}), bits(solve(problem, 1e-2))) << i;
  }
}

// Lengths × 2^k and strengths × 2^(2k + 3): velocities × 8, bit for bit.
TEST(Direct, ScalesExactlyWithTheUnitOfLength) {
  for (const double delta : {0.0, 1e-2}) {
    const Problem problem = random_problem(301, 37, 11);
    const auto unscaled = solve(problem, delta);
    for (const int k : {-250, -20, -1, 1, 20, 250}) {
      const double length = std::ldexp(1.0, k);
      Problem scaled = problem;
      for (auto* array : {&scaled.sources.x, &scaled.sources.y, &scaled.sources.z}) {
        for (double& value : *array) value *= length;
      }
      for (auto* array : {&scaled.sources.gx, &scaled.sources.gy, &scaled.sources.gz}) {
        for (double& value : *array) value *= 8 * length * length;
      }
      for (Vec3& x : scaled.targets) x *= length;
      auto u = solve(scaled, delta * length);
      for (Vec3& value : u) value /= 8;
      EXPECT_EQ(bits(unscaled), bits(u)) << "delta = " << delta << ", k = " << k;
    }
  }
}

// Every target sits on a source, as vertices of collapsed triangles may; δ = 0 makes that 0/0.
TEST_P(EveryInstructionSet, TargetOnSourceGetsNothingFromIt) {
  for (const double delta : {0.0, 1e-300, 1e-3}) {
    Problem problem = random_problem(77, 0, 12);
    for (std::size_t t = 0; t < problem.sources.size(); ++t) {
      problem.targets.emplace_back(problem.sources.x[t], problem.sources.y[t], problem.sources.z[t]);
    }
    expect_accurate(problem, delta);
  }
}

TEST(Direct, SourceAloneDoesNotMoveItself) {
  VortexSources sources;
  sources.resize(1);
  sources.set(0, Vec3(0.1, 0.2, 0.3), Vec3(1e8, -2e8, 3e8));
  EXPECT_EQ(solve({sources, {Vec3(0.1, 0.2, 0.3)}}, 0).front(), Vec3(0, 0, 0));
}

// A hair from a strong source: the one large term must not spoil, nor be spoiled by, the shift of the origin.
TEST(Direct, TargetsCloseToSourcesFarFromTheOrigin) {
  Problem problem = random_problem(64, 0, 13);
  for (auto* array : {&problem.sources.x, &problem.sources.y, &problem.sources.z}) {
    for (double& value : *array) value += 1e6;
  }
  for (std::size_t t = 0; t < problem.sources.size(); ++t) {
    const Vec3 source(problem.sources.x[t], problem.sources.y[t], problem.sources.z[t]);
    problem.targets.emplace_back(source + Vec3(1e-8, -2e-8, 3e-8));
  }
  expect_accurate(problem, 0);
}

}  // namespace
}  // namespace foamsim
