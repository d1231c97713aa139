// Continuous collision detection against exact arithmetic: a hundred million queries, or as many as the environment
// variable FOAMSIM_CCD_QUERIES says, a quarter of them in each set. The adversarial ones are of the families that
// ccd_queries.cpp names: on a lattice, coplanar, denormal, huge, scaled and others.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "tests/LosTopos/geometry/ccd_checks.h"

namespace lostopos::test {
namespace {

long queries_of_a_set() {
  const char* asked = std::getenv("FOAMSIM_CCD_QUERIES");
  const long all = asked != nullptr ? std::atol(asked) : 100000000;
  return std::max(all / 4, 1000L);
}

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
  const CheckResult result = check_against_oracle(Shape::vertex_triangle, false, queries_of_a_set(), 11);
  expect_sound(result);
  EXPECT_LT(result.false_hit_rate(), 0.01);
  EXPECT_LE(10000 * result.early, result.exact_hits);
}

TEST(CcdOracleLong, RandomEdgeEdge) {
  const CheckResult result = check_against_oracle(Shape::edge_edge, false, queries_of_a_set(), 12);
  expect_sound(result);
  EXPECT_LT(result.false_hit_rate(), 0.01);
  EXPECT_LE(10000 * result.early, result.exact_hits);
}

TEST(CcdOracleLong, AdversarialVertexTriangle) {
  expect_sound(check_against_oracle(Shape::vertex_triangle, true, queries_of_a_set(), 13));
}

TEST(CcdOracleLong, AdversarialEdgeEdge) {
  expect_sound(check_against_oracle(Shape::edge_edge, true, queries_of_a_set(), 14));
}

}  // namespace
}  // namespace lostopos::test
