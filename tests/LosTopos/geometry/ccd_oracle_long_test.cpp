// Continuous collision detection against exact arithmetic: a million random and a million adversarial queries.
#include <gtest/gtest.h>

#include "tests/LosTopos/geometry/ccd_checks.h"

namespace lostopos::test {
namespace {

constexpr long half_a_million = 500000;

void expect_sound(const CheckResult& result) {
  EXPECT_EQ(result.missed, 0) << result.first_failure;
  EXPECT_EQ(result.late, 0) << result.first_failure;
  EXPECT_EQ(result.order_dependent, 0) << result.first_failure;
  EXPECT_EQ(result.malformed, 0) << result.first_failure;
  EXPECT_GT(result.exact_hits, result.queries / 50) << "the set does not test hits";
  EXPECT_LT(result.exact_hits, result.queries * 9 / 10) << "the set does not test misses";
  EXPECT_LT(result.largest_gap, 1e-6) << "a hit where the shapes are apart";
}

TEST(CcdOracleLong, RandomVertexTriangle) {
  const CheckResult result = check_against_oracle(Shape::vertex_triangle, false, half_a_million, 11);
  expect_sound(result);
  EXPECT_LT(result.false_hit_rate(), 0.01);
  EXPECT_LT(result.early, result.exact_hits / 10000);
}

TEST(CcdOracleLong, RandomEdgeEdge) {
  const CheckResult result = check_against_oracle(Shape::edge_edge, false, half_a_million, 12);
  expect_sound(result);
  EXPECT_LT(result.false_hit_rate(), 0.01);
  EXPECT_LT(result.early, result.exact_hits / 10000);
}

TEST(CcdOracleLong, AdversarialVertexTriangle) {
  expect_sound(check_against_oracle(Shape::vertex_triangle, true, half_a_million, 13));
}

TEST(CcdOracleLong, AdversarialEdgeEdge) {
  expect_sound(check_against_oracle(Shape::edge_edge, true, half_a_million, 14));
}

}  // namespace
}  // namespace lostopos::test
