#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "Base/error.h"
#include "FoamSim/metrics/metrics.h"
#include "FoamSim/scenes/shapes/double_bubble.h"
#include "FoamSim/studies/stability/shapes/border_edits.h"
#include "FoamSim/studies/stability/shapes/clusters.h"
#include "LosTopos/mesh/audit.h"

namespace foamsim {
namespace {

using lostopos::SurfaceMesh;
using lostopos::Vec3;
using lostopos::Vertex;

TEST(BlockOfCubes, HasUnitCubesThatShareTheirWalls) {
  const SurfaceMesh mesh = block_of_cubes({2, 2, 1}, 3);
  EXPECT_TRUE(lostopos::audit(mesh).clean()) << lostopos::audit(mesh).text();
  const auto volumes = lostopos::region_volumes(mesh);
  ASSERT_EQ(volumes.size(), 5U);
  for (std::size_t i = 1; i < 5; ++i) EXPECT_NEAR(volumes[i].volume, 1, 1e-12);
  EXPECT_NEAR(lostopos::total_area(mesh), 16 + 4, 1e-12) << "sixteen squares outside, four walls";
  std::size_t four_films = 0;
  for (lostopos::Edge e : mesh.edges()) four_films += mesh.triangles(e).size() == 4 ? 1 : 0;
  EXPECT_EQ(four_films, 3U) << "the line in the middle";
  EXPECT_THROW(block_of_cubes({0, 1, 1}, 1), base::InputError);
}

TEST(TetrahedralCluster, CutsTheBallIntoFourEqualBubbles) {
  const TetrahedralCluster cluster = tetrahedral_cluster(12);
  EXPECT_TRUE(lostopos::audit(cluster.mesh).clean()) << lostopos::audit(cluster.mesh).text();
  const auto volumes = lostopos::region_volumes(cluster.mesh);
  ASSERT_EQ(volumes.size(), 5U);
  for (std::size_t i = 1; i < 5; ++i) {
    EXPECT_NEAR(volumes[i].volume, volumes[1].volume, 1e-12);
    EXPECT_NEAR(volumes[i].volume, std::numbers::pi / 3, 0.03 * std::numbers::pi / 3);
  }
  EXPECT_EQ(cluster.mesh.position(cluster.middle), Vec3::Zero());
  std::size_t borders = 0;
  for (lostopos::Edge e : cluster.mesh.edges(cluster.middle)) borders += cluster.mesh.is_junction(e) ? 1 : 0;
  EXPECT_EQ(borders, 4U) << "a Plateau vertex";
  EXPECT_THROW(tetrahedral_cluster(1), base::InputError);
}

TEST(DividedBorders, StretchTrianglesAndMoveNoPointOfTheSurface) {
  const SurfaceMesh plain = double_bubble(16);
  const SurfaceMesh divided = with_divided_borders(plain, 8);
  EXPECT_TRUE(lostopos::audit(divided).clean()) << lostopos::audit(divided).text();
  EXPECT_EQ(divided.triangle_count(), plain.triangle_count() + 16 * 3 * 7);
  EXPECT_NEAR(lostopos::total_area(divided), lostopos::total_area(plain), 1e-12);
  const auto before = lostopos::region_volumes(plain);
  EXPECT_LT(largest_volume_drift(lostopos::region_volumes(divided), before), 1e-12);
  // The wall's triangles have two sides to its middle, R long, and an eighth of 2R sin(π/16) on the border.
  EXPECT_NEAR(most_stretched_at_borders(divided), 8 / std::sin(std::numbers::pi / 8), 1e-9);
  EXPECT_EQ(with_divided_borders(plain, 1).triangle_count(), plain.triangle_count());
  EXPECT_THROW(with_divided_borders(plain, 0), base::InputError);
}

TEST(PressedSlivers, AreThinAndIntersectNothing) {
  SurfaceMesh mesh = double_bubble(16);
  const double height = 0.02 * lostopos::mean_edge_length(mesh);
  const double before = most_stretched_at_borders(mesh);
  EXPECT_EQ(press_slivers(mesh, height), 16U) << "every second edge, on both caps";
  EXPECT_TRUE(lostopos::audit(mesh).clean()) << lostopos::audit(mesh).text();
  EXPECT_GT(most_stretched_at_borders(mesh), 5 * before);
  EXPECT_LT(smallest_triangle_angle(mesh), 8);
}

TEST(Noise, IsBoundedAndRepeatable) {
  const SurfaceMesh plain = double_bubble(8);
  SurfaceMesh one = plain.clone(), two = plain.clone(), other = plain.clone();
  add_noise(one, 0.01, 5);
  add_noise(two, 0.01, 5);
  add_noise(other, 0.01, 6);
  double largest = 0, difference = 0;
  Vec3 sum = Vec3::Zero();
  for (Vertex v : plain.vertices()) {
    const Vec3 moved = one.position(v) - plain.position(v);
    EXPECT_EQ(one.position(v), two.position(v));
    largest = std::max(largest, moved.cwiseAbs().maxCoeff());
    difference = std::max(difference, (one.position(v) - other.position(v)).norm());
    sum += moved;
  }
  EXPECT_LE(largest, 0.01 * (1 + 1e-12));
  EXPECT_GT(largest, 0.009);
  EXPECT_GT(difference, 0.005);
  EXPECT_LT(sum.norm() / static_cast<double>(plain.vertex_count()), 0.002) << "without a preferred direction";
}

}  // namespace
}  // namespace foamsim
