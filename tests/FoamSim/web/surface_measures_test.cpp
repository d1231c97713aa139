#include "FoamSim/web/surface_measures.h"

#include <gtest/gtest.h>

#include <numbers>

#include "small_run.h"
#include "tests/support/sample_meshes.h"

namespace foamsim::web {
namespace {

using std::numbers::pi;

TEST(SurfaceMeasures, OfASphereAreThoseOfTheBall) {
  const double radius = 2;
  const SurfaceMeasures measures = measure(lostopos::from_mesh(lostopos::test::globe(radius, 40)));
  ASSERT_EQ(measures.bubbles.size(), 1u);
  const BubbleMeasures& bubble = measures.bubbles[0];
  EXPECT_EQ(bubble.region, 1u);
  EXPECT_EQ(bubble.faces, 1u);
  EXPECT_NEAR(bubble.volume, 4 * pi / 3 * radius * radius * radius, 0.3);
  EXPECT_NEAR(bubble.area, 4 * pi * radius * radius, 0.3);
  EXPECT_NEAR(bubble.pressure, 2 / radius, 0.02);
  EXPECT_NEAR(bubble.centre.norm(), 0, 1e-9);
  EXPECT_TRUE(measures.borders.empty());
  for (double curvature : measures.mean_curvature) EXPECT_NEAR(curvature, 1 / radius, 0.05);
}

TEST(SurfaceMeasures, HaveBordersWhereThreeFilmsMeet) {
  const SurfaceMeasures measures = measure(test::SmallRun::surface(0));
  EXPECT_EQ(measures.borders, (std::vector<std::array<std::uint32_t, 2>>{{0, 1}, {0, 2}, {1, 2}}));
  ASSERT_EQ(measures.bubbles.size(), 2u);
  for (const BubbleMeasures& bubble : measures.bubbles) {
    EXPECT_NEAR(bubble.volume, 1.0 / 6, 1e-12);
    EXPECT_EQ(bubble.faces, 2u);
  }
}

TEST(SurfaceMeasures, SayOfAnOpenBubbleThatItHasNoVolume) {
  lostopos::SurfaceData open = test::SmallRun::surface(0);
  open.triangles.pop_back();
  open.labels.pop_back();
  const SurfaceMeasures measures = measure(open);
  ASSERT_EQ(measures.bubbles.size(), 2u);
  EXPECT_FALSE(std::isnan(measures.bubbles[0].volume));
  EXPECT_TRUE(std::isnan(measures.bubbles[1].volume));
}

TEST(SurfaceMeasures, OfNothingAreNothing) {
  const SurfaceMeasures measures = measure({});
  EXPECT_TRUE(measures.bubbles.empty());
  EXPECT_TRUE(measures.borders.empty());
}

// Two spheres in one foam, one twice as large: the pressures stand as the radii.
TEST(SurfaceMeasures, PressuresAreThoseOfYoungAndLaplace) {
  lostopos::SurfaceData both = lostopos::from_mesh(lostopos::test::globe(1, 30));
  const lostopos::SurfaceData other = lostopos::from_mesh(lostopos::test::globe(2, 30, {5, 0, 0}));
  const auto first = static_cast<std::uint32_t>(both.positions.size());
  both.positions.insert(both.positions.end(), other.positions.begin(), other.positions.end());
  for (const auto& [a, b, c] : other.triangles) {
    both.triangles.push_back({a + first, b + first, c + first});
    both.labels.push_back({lostopos::Region{7}, lostopos::air});
  }
  const SurfaceMeasures measures = measure(both);
  ASSERT_EQ(measures.bubbles.size(), 2u);
  EXPECT_NEAR(measures.bubbles[0].pressure, 2, 0.03);
  EXPECT_NEAR(measures.bubbles[1].pressure, 1, 0.03);
}

}  // namespace
}  // namespace foamsim::web
