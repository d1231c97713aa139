#include "LosTopos/geometry/triangle_quality.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace lostopos::test {
namespace {

using std::numbers::pi;
using std::numbers::sqrt3;

const Vec3 a(0, 0, 0);
const Vec3 b(4, 0, 0);
const Vec3 c(0, 3, 0);

TEST(TriangleQuality, RightTriangle) {
  EXPECT_DOUBLE_EQ(triangle_area(a, b, c), 6);
  EXPECT_EQ(triangle_normal(a, b, c), Vec3(0, 0, 1));
  EXPECT_EQ(triangle_normal(a, c, b), Vec3(0, 0, -1));
  const Vec3 angles = triangle_angles(a, b, c);
  EXPECT_DOUBLE_EQ(angles[0], pi / 2);
  EXPECT_DOUBLE_EQ(angles[1], std::atan(0.75));
  EXPECT_DOUBLE_EQ(angles[2], std::atan(4.0 / 3));
  EXPECT_DOUBLE_EQ(min_angle(a, b, c), std::atan(0.75));
  EXPECT_DOUBLE_EQ(max_angle(a, b, c), pi / 2);
  EXPECT_DOUBLE_EQ(aspect_ratio(a, b, c), sqrt3 / 2 * 5 / (12.0 / 5));
}

TEST(TriangleQuality, EquilateralHasAspectOne) {
  EXPECT_NEAR(aspect_ratio({1, 0, 0}, {0, 1, 0}, {0, 0, 1}), 1, 1e-15);
  EXPECT_NEAR(min_angle({1, 0, 0}, {0, 1, 0}, {0, 0, 1}), pi / 3, 1e-15);
}

TEST(TriangleQuality, AnglesOfANeedleAreAccurate) {
  const double thin = 1e-12;
  const Vec3 angles = triangle_angles({0, 0, 0}, {1, 0, 0}, {0.5, thin, 0});
  EXPECT_NEAR(angles[0], 2 * thin, 1e-26);
  EXPECT_NEAR(angles[1], 2 * thin, 1e-26);
  EXPECT_NEAR(pi - angles[2], 4 * thin, 1e-15);
  EXPECT_NEAR(angles.sum(), pi, 1e-15);
}

TEST(TriangleQuality, CollapsedTriangles) {
  EXPECT_EQ(triangle_area(a, b, Vec3(2, 0, 0)), 0);
  EXPECT_EQ(triangle_normal(a, b, Vec3(2, 0, 0)), Vec3::Zero());
  EXPECT_EQ(aspect_ratio(a, b, Vec3(2, 0, 0)), HUGE_VAL);
  EXPECT_EQ(aspect_ratio(a, a, a), HUGE_VAL);
  EXPECT_EQ(max_angle(a, b, Vec3(2, 0, 0)), pi);
  EXPECT_EQ(corner_angle(a, a, b), 0);
  EXPECT_EQ(dihedral_angle(a, a, b, c), 0);
  EXPECT_EQ(dihedral_angle(a, b, Vec3(1, 0, 0), c), 0);
}

TEST(TriangleQuality, TinyAndHugeTriangles) {
  for (const double k : {1e-300, 1e-160, 1e160, 1e300}) {
    EXPECT_LT((triangle_normal(k * a, k * b, k * c) - Vec3::UnitZ()).norm(), 1e-15);
    EXPECT_NEAR(min_angle(k * a, k * b, k * c), std::atan(0.75), 1e-15);
    EXPECT_NEAR(aspect_ratio(k * a, k * b, k * c), aspect_ratio(a, b, c), 1e-14);
    EXPECT_NEAR(dihedral_angle(k * a, k * b, k * c, k * Vec3(0, 0, 1)), pi / 2, 1e-15);
  }
}

TEST(TriangleQuality, DihedralAngleTurnsRightHandedly) {
  const Vec3 e1(0, 0, 2);
  for (const double angle : {-3.0, -2.0, -0.1, 1e-9, 0.5, 2.0, 3.0}) {
    const Vec3 turned(std::cos(angle), std::sin(angle), 1);
    EXPECT_NEAR(dihedral_angle(Vec3::Zero(), e1, {1, 0, 0.3}, turned), angle, 1e-15);
    EXPECT_NEAR(dihedral_angle(Vec3::Zero(), e1, turned, {1, 0, 0.3}), -angle, 1e-15);
    EXPECT_NEAR(dihedral_angle(e1, Vec3::Zero(), {1, 0, 0.3}, turned), -angle, 1e-15);
  }
  EXPECT_DOUBLE_EQ(std::abs(dihedral_angle(Vec3::Zero(), e1, {1, 0, 0}, {-1, 0, 0})), pi) << "flat";
  EXPECT_EQ(dihedral_angle(Vec3::Zero(), e1, {1, 0, 0}, {2, 0, 1}), 0) << "folded";
}

}  // namespace
}  // namespace lostopos::test
