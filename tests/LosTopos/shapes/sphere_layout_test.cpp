#include "LosTopos/shapes/sphere_layout.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "Base/error.h"
#include "LosTopos/mesh/audit.h"
#include "LosTopos/mesh/measures.h"

namespace lostopos {
namespace {

double smallest_gap(const std::vector<Sphere>& spheres) {
  double gap = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < spheres.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      gap = std::min(gap, (spheres[i].centre - spheres[j].centre).norm() - spheres[i].radius - spheres[j].radius);
  return gap;
}

class SphereLayouts : public testing::TestWithParam<std::tuple<SphereLayout, long>> {};

TEST_P(SphereLayouts, NeverTouchForAnySeed) {
  const auto [layout, count] = GetParam();
  const bool grid = layout == SphereLayout::grid;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const auto spheres = sphere_layout({.spheres = count, .layout = layout, .seed = seed});
    ASSERT_EQ(spheres.size(), static_cast<std::size_t>(count));
    EXPECT_GE(smallest_gap(spheres), 0.02 - 1e-12);
    for (const Sphere& sphere : spheres) {
      EXPECT_GE(sphere.radius, grid ? 0.34 : 0.15);
      EXPECT_LE(sphere.radius, grid ? 0.40 : 0.45);
      if (!grid) continue;
      const Vec3 off = sphere.centre - sphere.centre.array().round().matrix();
      EXPECT_LE(off.cwiseAbs().maxCoeff(), 0.08);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, SphereLayouts,
                         testing::Combine(testing::Values(SphereLayout::grid, SphereLayout::random),
                                          testing::Values(1L, 8L, 27L, 125L)));

TEST(SphereLayout, MeshesAreSpheresWithRegionsOfTheirOwnOrOne) {
  const auto spheres = sphere_layout({.spheres = 9, .layout = SphereLayout::random, .seed = 4});
  const SurfaceMesh mesh = sphere_meshes(spheres);
  EXPECT_EQ(audit(mesh).text(), "clean");
  EXPECT_EQ(mesh.triangle_count(), 9u * 320);
  const auto volumes = region_volumes(mesh);
  ASSERT_EQ(volumes.size(), 10u);
  const SurfaceMesh unit = sphere_meshes({{Vec3::Zero(), 1}});
  for (std::size_t i = 1; i < volumes.size(); ++i) {
    EXPECT_EQ(volumes[i].region, Region(i));
    EXPECT_NEAR(volumes[i].volume / std::pow(spheres[i - 1].radius, 3), region_volumes(unit)[1].volume, 1e-10);
  }
  const SurfaceMesh one = sphere_meshes(spheres, true);
  EXPECT_EQ(regions(one), (std::vector<Region>{air, Region(1)}));
  EXPECT_EQ(euler_characteristic(one), 18);
}

TEST(SphereLayout, SameSeedSameBitsAndOthersDiffer) {
  for (SphereLayout layout : {SphereLayout::grid, SphereLayout::random}) {
    const auto a = sphere_layout({.layout = layout, .seed = 2}), b = sphere_layout({.layout = layout, .seed = 2}),
               c = sphere_layout({.layout = layout, .seed = 3});
    for (std::size_t i = 0; i < a.size(); ++i) {
      EXPECT_EQ(a[i].centre, b[i].centre);
      EXPECT_EQ(a[i].radius, b[i].radius);
      EXPECT_NE(a[i].centre, c[i].centre);
    }
  }
}

TEST(SphereLayout, BadOptionsAreRefused) {
  EXPECT_THROW(sphere_layout({.spheres = 0}), base::InputError);
  EXPECT_THROW(sphere_layout({.spheres = 2'000'000}), base::InputError);
  EXPECT_EQ(sphere_layout_by_name("random"), SphereLayout::random);
  EXPECT_THROW(sphere_layout_by_name("gird"), base::InputError);
}

}  // namespace
}  // namespace lostopos
