#include "LosTopos/mesh/measures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "tests/support/sample_meshes.h"

namespace lostopos {
namespace {

using std::numbers::pi;

double volume(const SurfaceMesh& mesh, Region region) {
  for (const auto& [r, v] : region_volumes(mesh))
    if (r == region) return v;
  return std::numeric_limits<double>::quiet_NaN();
}

TEST(Measures, OfATetrahedronAreExact) {
  const SurfaceMesh mesh = test::corner_tetrahedron(2);
  EXPECT_DOUBLE_EQ(volume(mesh, Region(1)), 8.0 / 6);
  EXPECT_DOUBLE_EQ(total_area(mesh), 3 * 2 + std::sqrt(3.0) / 4 * 8);
  EXPECT_DOUBLE_EQ(mean_edge_length(mesh), (3 * 2 + 3 * std::sqrt(8.0)) / 6);
  EXPECT_EQ(area_vector(mesh, Triangle(0)), Vec3(0, 0, -2));
  EXPECT_EQ(barycentre(mesh, Triangle(0)), Vec3(2.0 / 3, 2.0 / 3, 0));
  EXPECT_EQ(euler_characteristic(mesh), 2);
  EXPECT_EQ(open_edge_count(mesh), 0U);
  EXPECT_EQ(junction_edge_count(mesh), 0U);
}

TEST(Measures, OfASphereConvergeAtSecondOrder) {
  const Vec3 centre(3, -2, 1);
  constexpr double radius = 1.5;
  double last_volume_error = 0, last_area_error = 0;
  for (long n : {8L, 16L, 32L, 64L}) {
    const SurfaceMesh mesh = test::globe(radius, n, centre);
    const double volume_error = 1 - volume(mesh, Region(1)) / (4 * pi / 3 * std::pow(radius, 3));
    const double area_error = 1 - total_area(mesh) / (4 * pi * radius * radius);
    EXPECT_GT(volume_error, 0) << "an inscribed polyhedron is smaller";
    EXPECT_GT(area_error, 0);
    EXPECT_LT((surface_centroid(mesh) - centre).norm(), 1e-12);
    if (n > 8) {
      EXPECT_NEAR(last_volume_error / volume_error, 4, 0.2);
      EXPECT_NEAR(last_area_error / area_error, 4, 0.2);
    }
    last_volume_error = volume_error;
    last_area_error = area_error;
  }
  EXPECT_LT(last_volume_error, 2e-3);
}

TEST(Measures, TheAirsVolumeIsMinusThatOfAllBubbles) {
  SurfaceMesh mesh = test::globe(1, 12);
  test::add_corner_tetrahedron(mesh, 0.5, {5, 0, 0}, Region(7), air);
  test::add_corner_tetrahedron(mesh, 0.1, {0, 0, 0}, Region(3), Region(1));
  const auto volumes = region_volumes(mesh);
  ASSERT_EQ(volumes.size(), 4U);
  EXPECT_TRUE(std::ranges::is_sorted(volumes, {}, &RegionVolume::region));
  EXPECT_NEAR(volume(mesh, Region(7)), 0.125 / 6, 1e-14);
  EXPECT_NEAR(volume(mesh, Region(3)), 0.001 / 6, 1e-14);
  EXPECT_NEAR(volume(mesh, Region(1)), volume(test::globe(1, 12), Region(1)) - 0.001 / 6, 1e-13) << "with a hole";
  EXPECT_NEAR(volume(mesh, air), -(volume(mesh, Region(1)) + volume(mesh, Region(3)) + volume(mesh, Region(7))), 1e-13);
}

TEST(Measures, AThousandRadiiFromTheOriginCostNoDigits) {
  const Vec3 far(1000, -2000, 3000);
  const SurfaceMesh here = test::globe(1, 16), there = test::globe(1, 16, far);
  // The positions themselves are rounded to 3000 · 2⁻⁵³.
  EXPECT_NEAR(volume(there, Region(1)) / volume(here, Region(1)), 1, 1e-12);
  EXPECT_NEAR(total_area(there) / total_area(here), 1, 1e-12);
  EXPECT_LT((surface_centroid(there) - far).norm(), 1e-11);
}

TEST(Measures, ScaleByPowersOfTwoExactly) {
  for (int exponent : {-200, -20, 20, 200}) {
    const double s = std::ldexp(1.0, exponent);
    const SurfaceMesh one = test::globe(1, 8), scaled = test::globe(s, 8);
    EXPECT_EQ(volume(scaled, Region(1)), volume(one, Region(1)) * s * s * s);
    EXPECT_EQ(total_area(scaled), total_area(one) * s * s);
    EXPECT_EQ(mean_edge_length(scaled), mean_edge_length(one) * s);
  }
}

TEST(Measures, EulerCharacteristicTellsShapesApart) {
  EXPECT_EQ(euler_characteristic(test::globe(1, 8)), 2);
  EXPECT_EQ(euler_characteristic(test::open_cylinder(1, 8, 3, 0.5)), 0);
  EXPECT_EQ(euler_characteristic(test::triple_junction({120, 120, 120}).mesh), 1);
}

TEST(Measures, CountOpenAndJunctionEdges) {
  EXPECT_EQ(open_edge_count(test::open_cylinder(1, 8, 3, 0.5)), 16U);
  const SurfaceMesh junction = test::triple_junction({120, 120, 120}).mesh;
  EXPECT_EQ(junction_edge_count(junction), 6U);
  EXPECT_EQ(open_edge_count(junction), 3U * (6 + 2 * 4));
}

TEST(Measures, OfAnEmptyMeshAreZero) {
  const SurfaceMesh mesh;
  EXPECT_EQ(mean_edge_length(mesh), 0);
  EXPECT_EQ(total_area(mesh), 0);
  EXPECT_TRUE(region_volumes(mesh).empty());
  EXPECT_TRUE(regions(mesh).empty());
  EXPECT_EQ(euler_characteristic(mesh), 0);
}

TEST(Measures, RegionsNeedNotBeNumberedWithoutGaps) {
  SurfaceMesh mesh;
  test::add_corner_tetrahedron(mesh, 1, {0, 0, 0}, Region(4000000000U), air);
  EXPECT_EQ(regions(mesh), (std::vector<Region>{air, Region(4000000000U)}));
  EXPECT_NEAR(volume(mesh, Region(4000000000U)), 1.0 / 6, 1e-15);
}

}  // namespace
}  // namespace lostopos
