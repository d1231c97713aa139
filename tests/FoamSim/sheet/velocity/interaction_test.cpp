#include "FoamSim/sheet/velocity/interaction.h"

#include <gtest/gtest.h>

#include <random>

namespace foamsim {
namespace {

using lostopos::Vec3;

struct SheetAndPart {
  VortexSources all, part;
};

// `every`: of the sources, one in so many is in the part.
SheetAndPart random_sheet(std::size_t n, std::size_t every) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> value(-1, 1);
  const auto vector = [&] { return Vec3(value(random), value(random), value(random)); };
  SheetAndPart sheet;
  sheet.all.resize(n);
  sheet.part.resize(n);
  for (std::size_t t = 0; t < n; ++t) {
    const Vec3 place = vector();
    sheet.all.set(t, place, vector());
    sheet.part.set(t, place, t % every == 0 ? vector() : Vec3::Zero());
  }
  return sheet;
}

double written_out(const SheetAndPart& sheet, double delta) {
  DirectPairSums pairs;
  PairSums sums;
  pairs.evaluate(sheet.all, delta, PairTerms::potential, sums);
  double sum = 0;
  for (std::size_t t = 0; t < sheet.all.size(); ++t)
    sum += Vec3(sheet.part.gx[t], sheet.part.gy[t], sheet.part.gz[t]).dot(sums.potential[t]);
  return sum;
}

// Few sources and many, on either side of where the way of summing changes.
TEST(Interaction, IsThePartTimesThePotentialOfAll) {
  constexpr double delta = 0.1;
  DirectPairSums pairs;
  for (std::size_t every : {1U, 3U, 7U, 50U, 500U}) {
    const SheetAndPart sheet = random_sheet(400, every);
    const double expected = written_out(sheet, delta);
    EXPECT_NEAR(interaction(sheet.part, sheet.all, delta, pairs), expected, 1e-12 * 400) << every;
  }
}

TEST(Interaction, IsZeroOfNothing) {
  DirectPairSums pairs;
  SheetAndPart sheet = random_sheet(40, 1);
  sheet.part = {};
  sheet.part.resize(40);
  EXPECT_EQ(interaction(sheet.part, sheet.all, 0.1, pairs), 0);
  EXPECT_EQ(interaction({}, {}, 0.1, pairs), 0);
}

}  // namespace
}  // namespace foamsim
