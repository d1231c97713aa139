// Continuous collision detection against exact arithmetic: samples of the sets that ccd_oracle_long_test.cpp runs
// whole.
#include <gtest/gtest.h>

#include "tests/LosTopos/geometry/ccd_checks.h"

namespace lostopos::test {
namespace {

constexpr long sample = 10000;

void expect_sound(const CheckResult& result) {
  EXPECT_EQ(result.missed, 0) << result.first_failure;
  EXPECT_EQ(result.late, 0) << result.first_failure;
  EXPECT_EQ(result.order_dependent, 0) << result.first_failure;
  EXPECT_EQ(result.malformed, 0) << result.first_failure;
  EXPECT_GT(result.exact_hits, result.queries / 50) << "the set does not test hits";
  EXPECT_LT(result.exact_hits, result.queries * 9 / 10) << "the set does not test misses";
  EXPECT_LT(result.largest_gap, 1e-6) << "a hit where the shapes are apart";
}

TEST(CcdOracle, RandomVertexTriangle) {
  const CheckResult result = check_against_oracle(Shape::vertex_triangle, false, sample, 1);
  expect_sound(result);
  EXPECT_LT(result.false_hit_rate(), 0.01);
  EXPECT_EQ(result.early, 0);
}

TEST(CcdOracle, RandomEdgeEdge) {
  const CheckResult result = check_against_oracle(Shape::edge_edge, false, sample, 2);
  expect_sound(result);
  EXPECT_LT(result.false_hit_rate(), 0.01);
  EXPECT_EQ(result.early, 0);
}

TEST(CcdOracle, AdversarialVertexTriangle) {
  expect_sound(check_against_oracle(Shape::vertex_triangle, true, sample, 3));
}

TEST(CcdOracle, AdversarialEdgeEdge) {
  expect_sound(check_against_oracle(Shape::edge_edge, true, sample, 4));
}

TEST(CcdOracle, ALaterPartIsThatOfTheWhole) {
  constexpr long part = 1L << 15U;
  const CheckResult whole = check_against_oracle(Shape::edge_edge, false, 2 * part, 5);
  const CheckResult first = check_against_oracle(Shape::edge_edge, false, part, 5);
  const CheckResult second = check_against_oracle(Shape::edge_edge, false, part, 5, part);
  EXPECT_EQ(first.exact_hits + second.exact_hits, whole.exact_hits);
  EXPECT_NE(first.exact_hits, second.exact_hits);
}

}  // namespace
}  // namespace lostopos::test
