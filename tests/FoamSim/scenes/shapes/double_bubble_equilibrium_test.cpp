// The standard double bubble against tabulated values, and against what makes it an equilibrium.
#include "FoamSim/scenes/shapes/double_bubble_equilibrium.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "Base/error.h"
#include "tests/support/reference_values.h"

namespace foamsim {
namespace {

using lostopos::test::reference_value;
using std::numbers::pi;

double cap_volume(const SphericalFilm& film, double rim) {
  const double height = rim * std::tan(film.polar_angle / 2);
  return pi * height / 6 * (3 * rim * rim + height * height);
}

TEST(DoubleBubbleEquilibrium, OfEqualVolumesHasTheTabulatedValues) {
  const DoubleBubbleEquilibrium one = double_bubble_equilibrium(1, 1);
  EXPECT_NEAR(one.total_area(), reference_value("dbl_sym_V1", "total area"), 1e-11);
  EXPECT_NEAR(one.outer[0].radius, reference_value("dbl_sym_V1", "outer radius"), 1e-12);
  EXPECT_NEAR(one.rim_radius, reference_value("dbl_sym_V1", "rim"), 1e-12);
  EXPECT_NEAR(one.wall.area, reference_value("dbl_sym_V1", "disk area"), 1e-12);
  EXPECT_NEAR(one.pressure(1), reference_value("dbl_sym_V1", "pressure"), 1e-11);
  EXPECT_TRUE(std::isinf(one.wall.radius));
  EXPECT_EQ(one.wall.polar_angle, 0);
  const DoubleBubbleEquilibrium report = double_bubble_equilibrium(4.02694, 4.02694);
  EXPECT_NEAR(report.total_area(), reference_value("dbl_sym_V4.02694", "total area"), 1e-10);
  EXPECT_NEAR(report.outer[1].radius, reference_value("dbl_sym_V4.02694", "outer radius"), 1e-11);
}

TEST(DoubleBubbleEquilibrium, OfOneToTwoHasTheTabulatedValues) {
  const DoubleBubbleEquilibrium e = double_bubble_equilibrium(1, 2);
  EXPECT_NEAR(e.total_area(), reference_value("dbl_V1_V2", "total area"), 1e-10);
  EXPECT_NEAR(e.outer[0].radius, reference_value("dbl_V1_V2", "r1"), 1e-11);
  EXPECT_NEAR(e.outer[1].radius, reference_value("dbl_V1_V2", "r2"), 1e-11);
  EXPECT_NEAR(e.wall.radius, reference_value("dbl_V1_V2", "r0"), 1e-10);
  EXPECT_NEAR(e.rim_radius, reference_value("dbl_V1_V2", "rim"), 1e-11);
  EXPECT_NEAR(e.pressure(0), reference_value("dbl_V1_V2", "p1"), 1e-10);
  EXPECT_NEAR(e.pressure(1), reference_value("dbl_V1_V2", "p2"), 1e-10);
  // The table's row of three: interface / outer 1 / outer 2.
  EXPECT_NEAR(e.wall.area, 1.251948957656, 1e-10);
  EXPECT_NEAR(e.outer[0].area, 3.870064760167, 1e-10);
  EXPECT_NEAR(e.outer[1].area, 6.732279410182, 1e-10);
}

TEST(DoubleBubbleEquilibrium, EnclosesItsVolumesAndBalancesPressuresAtEveryRatio) {
  for (double ratio : {1.0, 1 + 2e-16, 1 + 1e-15, 1 + 1e-12, 1.001, 1.5, 4.0, 1e3, 1e6, 1e9})
    for (double scale : {1.0, 1e-9, 1e9}) {
      const DoubleBubbleEquilibrium e = double_bubble_equilibrium(scale, ratio * scale);
      const double wall = cap_volume(e.wall, e.rim_radius);
      EXPECT_NEAR((cap_volume(e.outer[0], e.rim_radius) + wall) / scale, 1, 1e-9) << ratio;
      EXPECT_NEAR((cap_volume(e.outer[1], e.rim_radius) - wall) / (ratio * scale), 1, 1e-8) << ratio;
      // Young and Laplace: the wall carries the difference of the pressures.
      EXPECT_NEAR((e.pressure(0) - e.pressure(1) - 2 / e.wall.radius) / e.pressure(0), 0, 1e-12) << ratio;
      // Scaling an equilibrium (dE = Σ p dV): 2 E = 3 Σ p V.
      EXPECT_NEAR(1.5 * (e.pressure(0) * e.volumes[0] + e.pressure(1) * e.volumes[1]) / e.total_area(), 1, 1e-8);
    }
}

TEST(DoubleBubbleEquilibrium, DoesNotDependOnTheOrderOfTheBubbles) {
  const DoubleBubbleEquilibrium a = double_bubble_equilibrium(1, 3), b = double_bubble_equilibrium(3, 1);
  EXPECT_EQ(a.outer[0].radius, b.outer[1].radius);
  EXPECT_EQ(a.outer[1].area, b.outer[0].area);
  EXPECT_EQ(a.wall.area, b.wall.area);
  EXPECT_EQ(a.total_area(), b.total_area());
}

TEST(DoubleBubbleEquilibrium, RefusesWhatIsNoVolume) {
  for (double bad : {0.0, -1.0, std::numeric_limits<double>::infinity(), std::nan(""), 1e-10})
    EXPECT_THROW(double_bubble_equilibrium(bad, 1), base::InputError) << bad;
}

}  // namespace
}  // namespace foamsim
