// Continuous collision detection against exact arithmetic: a hundred million queries, or as many as the environment
// variable FOAMSIM_CCD_QUERIES says, a quarter of them in each set. FOAMSIM_CCD_FROM: so many of the stream are passed
// over, so that a large number can be looked at in runs of their own. The adversarial ones are of the families that
// ccd_queries.cpp names: on a lattice, coplanar, denormal, huge, scaled and others.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "tests/LosTopos/geometry/ccd_checks.h"

namespace lostopos::test {
namespace {

long number_from_environment(const char* name, long otherwise) {
  const char* given = std::getenv(name);
  return given != nullptr ? std::atol(given) : otherwise;
}

// The share that one of the four sets has of the queries.
CheckResult check_share(Shape shape, bool adversarial, std::uint64_t seed) {
  const long queries = number_from_environment("FOAMSIM_CCD_QUERIES", 100000000) / 4;
  const long from = number_from_environment("FOAMSIM_CCD_FROM", 0) / 4;
  return check_against_oracle(shape, adversarial, std::max(queries, 1000L), seed, std::max(from, 0L));
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
  const CheckResult result = check_share(Shape::vertex_triangle, false, 11);
  expect_sound(result);
  EXPECT_LT(result.false_hit_rate(), 0.01);
  EXPECT_LE(10000 * result.early, result.exact_hits);
}

TEST(CcdOracleLong, RandomEdgeEdge) {
  const CheckResult result = check_share(Shape::edge_edge, false, 12);
  expect_sound(result);
  EXPECT_LT(result.false_hit_rate(), 0.01);
  EXPECT_LE(10000 * result.early, result.exact_hits);
}

TEST(CcdOracleLong, AdversarialVertexTriangle) {
  expect_sound(check_share(Shape::vertex_triangle, true, 13));
}

TEST(CcdOracleLong, AdversarialEdgeEdge) {
  expect_sound(check_share(Shape::edge_edge, true, 14));
}

}  // namespace
}  // namespace lostopos::test
