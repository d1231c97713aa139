// The exact arithmetic that the collision oracle stands on.
#include "tests/support/exact_polynomial.h"

#include <gtest/gtest.h>

#include "tests/support/algebraic_number.h"
#include "tests/support/ccd_oracle.h"

namespace lostopos::test {
namespace {

Polynomial linear(int constant, int slope) {
  return Polynomial(Integer(constant), Integer(slope));
}

TEST(ExactPolynomial, RootsOfAProductOfLinearFactors) {
  // (3 t - 1)(4 t - 3)(t - 2)
  auto roots = roots_in_unit_interval(linear(-1, 3) * linear(-3, 4) * linear(-2, 1));
  ASSERT_EQ(roots.size(), 2U);
  for (auto& root : roots) root.refine(60);
  EXPECT_NEAR(roots[0].low().rounded_down(), 1.0 / 3, 1e-15);
  EXPECT_NEAR(roots[1].low().rounded_down(), 0.75, 1e-15);
  EXPECT_FALSE(roots[0].high() < roots[0].low());
}

TEST(ExactPolynomial, MultipleRootsCountOnce) {
  const Polynomial p = linear(-1, 3) * linear(-1, 3) * linear(-1, 2);
  EXPECT_EQ(roots_in_unit_interval(p).size(), 2U);
  EXPECT_EQ(roots_in_unit_interval(linear(-1, 3) * linear(-1, 3) * linear(-1, 3)).size(), 1U);
}

TEST(ExactPolynomial, EndsOfTheIntervalAreNotInIt) {
  EXPECT_TRUE(roots_in_unit_interval(linear(0, 1) * linear(-1, 1)).empty());
  EXPECT_EQ(roots_in_unit_interval(linear(0, 1) * linear(-1, 1) * linear(-1, 7)).size(), 1U);
}

TEST(ExactPolynomial, RootsTooCloseForDoubles) {
  // (2^80 t - 2^79 - 1)(2^80 t - 2^79)
  const Integer big = Integer(1) << 80;
  const Integer half = Integer(1) << 79;
  auto roots = roots_in_unit_interval(Polynomial(Integer(-half - 1), big) * Polynomial(Integer(-half), big));
  EXPECT_EQ(roots.size(), 2U);
}

TEST(ExactPolynomial, NoRealRoot) {
  // 4 t^2 - 4 t + 1 + 2^-100 has none, without the last term a double one.
  const Integer scale = Integer(1) << 100;
  const Polynomial square = linear(-1, 2) * linear(-1, 2) * Polynomial(scale);
  EXPECT_TRUE(roots_in_unit_interval(square + Polynomial(Integer(1))).empty());
  EXPECT_EQ(roots_in_unit_interval(square).size(), 1U);
  EXPECT_EQ(roots_in_unit_interval(square - Polynomial(Integer(1))).size(), 2U);
}

TEST(ExactPolynomial, SignsAtAnIrrationalRoot) {
  // t = 1 / sqrt(2), the root of 2 t^2 - 1.
  const Polynomial p = linear(0, 2) * linear(0, 1) - Polynomial(Integer(1));
  auto roots = roots_in_unit_interval(p);
  ASSERT_EQ(roots.size(), 1U);
  EXPECT_EQ(roots[0].sign_of(p), 0);
  EXPECT_EQ(roots[0].sign_of(p * linear(5, -3)), 0);
  EXPECT_EQ(roots[0].sign_of(Polynomial()), 0);
  // 408/577 and 985/1393 are convergents of 1/sqrt(2), below and above.
  EXPECT_EQ(roots[0].sign_of(linear(-408, 577)), 1);
  EXPECT_EQ(roots[0].sign_of(linear(-985, 1393)), -1);
}

TEST(ExactPolynomial, SignAtARootThatIsAlsoARootOfAnotherFactor) {
  const Polynomial p = linear(-1, 3) * linear(-2, 3);
  auto roots = roots_in_unit_interval(p);
  ASSERT_EQ(roots.size(), 2U);
  EXPECT_EQ(roots[0].sign_of(linear(-1, 3) * linear(-1, 3)), 0);
  EXPECT_EQ(roots[0].sign_of(linear(-2, 3)), -1);
  EXPECT_EQ(roots[1].sign_of(linear(-1, 3)), 1);
}

TEST(CcdOracle, TimeOfAKnownContact) {
  const auto rest = [](double x, double y, double z) { return Trajectory{{x, y, z}, {x, y, z}}; };
  const Trajectory p = {{0.25, 0.25, 1}, {0.25, 0.25, -2}};
  const auto contact = exact_vertex_triangle({p, rest(0, 0, 0), rest(1, 0, 0), rest(0, 1, 0)}, {.bits = 60});
  ASSERT_TRUE(contact);
  EXPECT_LE(contact->low, 1.0 / 3);
  EXPECT_GE(contact->high, 1.0 / 3);
  EXPECT_LT(contact->high - contact->low, 1e-15);
  EXPECT_FALSE(exact_vertex_triangle({p, rest(0, 0.5, 0), rest(1, 0.5, 0), rest(0, 1, 0)}));
}

}  // namespace
}  // namespace lostopos::test
