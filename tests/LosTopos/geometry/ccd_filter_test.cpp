// The collision oracle's proofs in ball arithmetic against its integers.
#include "tests/support/ccd_filter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <string>

#include "tests/LosTopos/geometry/ccd_queries.h"
#include "tests/support/ball.h"
#include "tests/support/exact_polynomial.h"

namespace lostopos::test {
namespace {

// In units of 2^-2200, far below the last bit of any product here.
Integer exact(double x) {
  if (x == 0) return 0;
  const int exponent = std::ilogb(x) - 52;
  return Integer(static_cast<std::int64_t>(std::scalbn(x, -exponent))) << static_cast<unsigned>(exponent + 2200);
}

bool holds(const Ball& ball, const Integer& number) {
  return boost::multiprecision::abs(number - exact(ball.value)) <= exact(ball.error);
}

double random_double(std::mt19937_64& bits) {
  const double mantissa = static_cast<double>(static_cast<std::int64_t>(bits())) * 0x1p-63;
  return std::ldexp(mantissa, static_cast<int>(bits() % 1060) - 1060);
}

TEST(Ball, HoldsExactSumsAndProducts) {
  std::mt19937_64 bits(7);
  for (int i = 0; i < 20000; ++i) {
    const Ball a{random_double(bits), std::abs(random_double(bits))};
    // Of similar size every other time, so that differences cancel.
    const Ball b{i % 2 == 0 ? random_double(bits) : a.value * (1 + 0x1p-40 * random_double(bits)), 0};
    const Integer x = exact(a.value) + exact(a.error);  // a member of a
    const Integer y = exact(b.value);
    ASSERT_TRUE(holds(a + b, x + y)) << a.value << ' ' << b.value;
    ASSERT_TRUE(holds(a - b, x - y)) << a.value << ' ' << b.value;
    // The product in the same units, up to less than one of them.
    const Integer product = (x * y) >> 2200;
    ASSERT_TRUE(holds(a * b, product)) << a.value << ' ' << b.value;
  }
}

TEST(Ball, HasNoSignWhenItOverflows) {
  const Ball huge{0x1p1000, 0};
  EXPECT_EQ(sign(huge * huge), 0);
  EXPECT_EQ(sign(huge * huge - huge * huge), 0);
  EXPECT_EQ(sign(huge), 1);
  EXPECT_EQ(sign(Ball{0, 0}), 0);
}

void expect_same_answers(Shape shape) {
  QueryGenerator generator(21);
  std::map<std::string, long> decided;
  constexpr int count = 9000;
  for (int i = 0; i < count; ++i) {
    const bool random = i % 10 == 0;
    const Query query = random ? generator.random() : generator.adversarial(shape);
    const std::optional<Collision> answer = collide(shape, query);
    const double time = answer ? answer->time : 0.5;
    const std::array<double, 2> apart_from = {time, std::min(time + 1e-6, 1.0)};
    const FilteredContact filtered = shape == Shape::vertex_triangle ? filter_vertex_triangle(query, 0, apart_from)
                                                                     : filter_edge_edge(query, 0, apart_from);
    if (!filtered.decided) continue;
    const auto family = std::string(random ? "random" : generator.family());
    ++decided[family];
    const auto exact = exact_contact(shape, query, {.apart_from = apart_from, .filter = false});
    ASSERT_EQ(filtered.contact.has_value(), exact.has_value()) << family << ", query " << i;
    if (!exact) continue;
    ASSERT_LE(filtered.contact->low, exact->high) << family << ", query " << i;
    ASSERT_GE(filtered.contact->high, exact->low) << family << ", query " << i;
    for (const double t : apart_from) {
      ASSERT_EQ(filtered.contact->is_before(t), exact->is_before(t)) << family << ", query " << i;
      ASSERT_EQ(filtered.contact->is_after(t), exact->is_after(t)) << family << ", query " << i;
    }
  }
  EXPECT_EQ(decided.size(), 13U) << "of each family some";
  EXPECT_GT(decided["random"], count / 10 * 8 / 10);
}

TEST(CcdFilter, AgreesWithIntegersOnVerticesAndTriangles) {
  expect_same_answers(Shape::vertex_triangle);
}

TEST(CcdFilter, AgreesWithIntegersOnEdges) {
  expect_same_answers(Shape::edge_edge);
}

TEST(CcdFilter, LeavesContactsAtTheStartAndOnBordersUndecided) {
  const auto rest = [](double x, double y, double z) { return Trajectory{{x, y, z}, {x, y, z}}; };
  const std::array<Trajectory, 3> triangle = {rest(0, 0, 0), rest(1, 0, 0), rest(0, 1, 0)};
  const auto decided = [&](const Vec3& start, const Vec3& end) {
    return filter_vertex_triangle({Trajectory{start, end}, triangle[0], triangle[1], triangle[2]}, 0, {}).decided;
  };
  EXPECT_TRUE(decided({0.25, 0.25, 1}, {0.25, 0.25, -1}));
  EXPECT_FALSE(decided({0.25, 0.25, 0}, {0.25, 0.25, -1}));
  EXPECT_FALSE(decided({0.5, 0.5, 1}, {0.5, 0.5, -2}));
  EXPECT_FALSE(decided({2, 0.25, 0}, {-1, 0.25, 0})) << "in the triangle's plane";
}

TEST(ExactPolynomial, DyadicNumbersRoundDownAndUp) {
  const Dyadic third{(Integer(1) << 100) / 3, 100};
  EXPECT_LT(third.rounded_down(), third.rounded_up());
  EXPECT_EQ(third.rounded_up(), std::nextafter(third.rounded_down(), 1));
  for (const double x : {0.0, 1.0, 0.1, 0x1p-1074, 0x1.8p-1040}) {
    EXPECT_EQ(Dyadic::of(x).rounded_down(), x);
    EXPECT_EQ(Dyadic::of(x).rounded_up(), x);
  }
}

}  // namespace
}  // namespace lostopos::test
