#include "FoamSim/scenes/shapes/double_bubble.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "Base/error.h"
#include "LosTopos/mesh/audit.h"
#include "LosTopos/mesh/measures.h"

namespace foamsim {
namespace {

using lostopos::air;
using lostopos::Edge;
using lostopos::Labels;
using lostopos::Region;
using lostopos::SurfaceMesh;
using lostopos::Triangle;
using lostopos::Vec3;
using lostopos::Vertex;
using std::numbers::pi;

TEST(DoubleBubble, HasTheReportsTriangleCounts) {
  EXPECT_EQ(double_bubble(16).triangle_count(), 880U);
  EXPECT_EQ(double_bubble(24).triangle_count(), 1992U);
  EXPECT_EQ(double_bubble(48).triangle_count(), 8016U);
  EXPECT_EQ(double_bubble(96).triangle_count(), 32160U);
}

class DoubleBubbleOf : public testing::TestWithParam<long> {
 protected:
  SurfaceMesh mesh = double_bubble(GetParam());
  long overlap = GetParam() / 8;  // rings
  double overlap_angle = pi * static_cast<double>(overlap) / static_cast<double>(GetParam());
};

TEST_P(DoubleBubbleOf, IsTwoSpheresGluedAlongADisc) {
  // Each closed bubble has characteristic 2, the disc that they share 1.
  EXPECT_EQ(lostopos::euler_characteristic(mesh), 3);
  EXPECT_EQ(lostopos::open_edge_count(mesh), 0U);
  EXPECT_EQ(lostopos::junction_edge_count(mesh), static_cast<std::size_t>(GetParam()));
  for (Edge e : mesh.edges()) EXPECT_LE(mesh.triangles(e).size(), 3U);
}

TEST_P(DoubleBubbleOf, PassesTheAudit) {
  EXPECT_EQ(lostopos::audit(mesh).text(), "clean");
}

TEST_P(DoubleBubbleOf, BubblesHaveEqualPositiveVolumesNearTheCaps) {
  const auto volumes = lostopos::region_volumes(mesh);
  ASSERT_EQ(volumes.size(), 3U);
  EXPECT_EQ(volumes[1].region, Region(1));
  EXPECT_GT(volumes[1].volume, 0);
  EXPECT_NEAR(volumes[1].volume / volumes[2].volume, 1, 1e-13);
  // The unit ball without the cap beyond the wall, whose height is 1 − cos(overlap).
  const double height = 1 - std::cos(overlap_angle);
  const double exact = 4 * pi / 3 - pi * height * height * (3 - height) / 3;
  const double h = 2 * pi / static_cast<double>(GetParam());
  EXPECT_LT(volumes[1].volume, exact);
  EXPECT_GT(volumes[1].volume, exact * (1 - 0.5 * h * h));
}

TEST_P(DoubleBubbleOf, LabelsSayWhichSideIsWhich) {
  std::size_t wall = 0;
  for (Triangle t : mesh.triangles()) {
    const Labels labels = mesh.labels(t);
    const Vec3 centre = lostopos::barycentre(mesh, t), normal = lostopos::area_vector(mesh, t).normalized();
    const Vec3& out_of_p = normal;  // right-hand normals point out of labels.p
    if (!labels.has(air)) {
      ++wall;
      EXPECT_EQ(std::abs(normal.x()), 1);
      EXPECT_EQ(labels.p, out_of_p.x() > 0 ? Region(1) : Region(2));
      EXPECT_EQ(labels.q, out_of_p.x() > 0 ? Region(2) : Region(1));
      continue;
    }
    const Region bubble = centre.x() < 0 ? Region(1) : Region(2);
    ASSERT_TRUE(labels.has(bubble));
    const Vec3 middle(std::copysign(std::cos(overlap_angle), centre.x()), 0, 0);
    EXPECT_EQ(out_of_p.dot(centre - middle) > 0, labels.p == bubble);
  }
  EXPECT_EQ(wall, static_cast<std::size_t>(GetParam())) << "a fan about the origin";
}

TEST_P(DoubleBubbleOf, VerticesLieOnTheUnitSpheresAndTheWallOnThePlaneBetween) {
  const double centre = std::cos(overlap_angle);
  for (Vertex v : mesh.vertices()) {
    const Vec3& x = mesh.position(v);
    if (x == Vec3(0, 0, 0)) continue;
    const Vec3 middle(x.x() < 0 ? -centre : centre, 0, 0);
    EXPECT_NEAR((x - middle).norm(), 1, 1e-14);
    if (mesh.is_junction(v)) {
      EXPECT_EQ(x.x(), 0);
      EXPECT_NEAR(x.norm(), std::sin(overlap_angle), 1e-15);
    }
  }
}

// 8 is the smallest; 9 and 17 have an overlap that is not N/8 exactly.
INSTANTIATE_TEST_SUITE_P(N, DoubleBubbleOf, testing::Values(8, 9, 16, 17, 23, 24, 48, 96));

TEST(DoubleBubble, NeedsEightSubdivisions) {
  for (long n : {7L, 0L, -1L}) EXPECT_THROW(double_bubble(n), base::InputError) << n;
  try {
    double_bubble(7);
  } catch (const base::InputError& error) {
    EXPECT_NE(std::string(error.what()).find("n >= 8"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find('7'), std::string::npos) << error.what();
  }
}

TEST(DoubleBubble, IsTheSameMirrored) {
  const SurfaceMesh mesh = double_bubble(24);
  EXPECT_LT(lostopos::surface_centroid(mesh).norm(), 1e-13);
}

}  // namespace
}  // namespace foamsim
