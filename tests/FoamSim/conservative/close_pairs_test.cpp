#include "FoamSim/conservative/close_pairs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace foamsim {
namespace {

using lostopos::Vec3;

std::vector<Vec3> cloud(std::size_t n) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  std::vector<Vec3> points(n);
  for (Vec3& x : points) x = Vec3(coordinate(random), coordinate(random), 0.3 * coordinate(random));
  return points;
}

std::vector<std::uint32_t> sorted(std::span<const std::uint32_t> close) {
  std::vector<std::uint32_t> list(close.begin(), close.end());
  std::ranges::sort(list);
  return list;
}

TEST(ClosePairs, AreAllThereAre) {
  const std::vector<Vec3> points = cloud(300);
  constexpr double distance = 0.25;
  const ClosePairs pairs = close_pairs(points, distance, 300);
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    std::vector<std::uint32_t> expected;
    for (std::uint32_t j = 0; j < points.size(); ++j)
      if ((points[i] - points[j]).norm() <= distance) expected.push_back(j);
    EXPECT_EQ(sorted(pairs.of(i)), expected) << i;
  }
}

TEST(ClosePairs, AreMutualAlsoWherePointsCrowd) {
  const std::vector<Vec3> points = cloud(300);
  const ClosePairs pairs = close_pairs(points, 5, 20);
  EXPECT_LE(pairs.other.size(), 20 * points.size());
  EXPECT_GT(pairs.other.size(), points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i)
    for (std::uint32_t j : pairs.of(i))
      EXPECT_TRUE(std::ranges::binary_search(sorted(pairs.of(j)), i)) << i << " " << j;
}

TEST(ClosePairs, OfNothingAreNone) {
  EXPECT_TRUE(close_pairs({}, 1, 10).other.empty());
}

}  // namespace
}  // namespace foamsim
