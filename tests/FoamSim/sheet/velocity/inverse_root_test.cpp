#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "FoamSim/sheet/velocity/inverse_root-inl.h"

namespace foamsim::HWY_NAMESPACE {
namespace {

// The largest relative error over many magnitudes.
template <class Real>
double worst_error(double least_exponent, double most_exponent) {
  const hn::CappedTag<Real, 1> one;
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> exponent(least_exponent, most_exponent);
  double worst = 0;
  for (int i = 0; i < 20000; ++i) {
    const Real x = static_cast<Real>(std::pow(10.0, exponent(random)));
    const double got = static_cast<double>(hn::GetLane(inverse_root(one, hn::Set(one, x))));
    worst = std::max(worst, std::abs(got * std::sqrt(static_cast<double>(x)) - 1));
  }
  return worst;
}

TEST(InverseRoot, IsGoodToAnUlpOrTwo) {
  EXPECT_LT(worst_error<float>(-37, 38), 2.5e-7);
  EXPECT_LT(worst_error<double>(-300, 300), 1e-15);
}

TEST(InverseRootCubed, IsGoodToThreeInTenMillion) {
  const hn::CappedTag<float, 1> one;
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> exponent(-12, 25);
  for (int i = 0; i < 20000; ++i) {
    const auto x = static_cast<float>(std::pow(10.0, exponent(random)));
    const auto got = static_cast<double>(hn::GetLane(inverse_root_cubed(one, hn::Set(one, x))));
    EXPECT_NEAR(got * std::pow(static_cast<double>(x), 1.5), 1, 6e-7) << x;
  }
}

TEST(InverseRoot, OfWhatIsTooLargeIsNearlyZero) {
  const hn::CappedTag<float, 1> one;
  const float got = hn::GetLane(inverse_root(one, hn::Set(one, std::numeric_limits<float>::infinity())));
  EXPECT_GE(got, 0);
  EXPECT_LT(got, 1e-18F);
}

TEST(InverseRoot, OfZeroIsZero) {
  const hn::CappedTag<float, 1> one;
  EXPECT_EQ(hn::GetLane(inverse_root(one, hn::Zero(one))), 0);
}

}  // namespace
}  // namespace foamsim::HWY_NAMESPACE
