#include "FoamSim/metrics/junction_angles.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "FoamSim/scenes/shapes/double_bubble.h"
#include "FoamSim/scenes/shapes/solids.h"
#include "tests/support/sample_meshes.h"

namespace foamsim {
namespace {

using lostopos::Region;
using lostopos::SurfaceMesh;
using lostopos::Triangle;
using lostopos::Vec3;
using lostopos::Vertex;
using lostopos::test::triple_junction;

double rms(double a, double b, double c) {
  return std::sqrt(((a - 120) * (a - 120) + (b - 120) * (b - 120) + (c - 120) * (c - 120)) / 3);
}

TEST(JunctionAngles, OfThreePlanesAreTheAnglesBetweenThem) {
  for (const auto& degrees :
       {std::array{120.0, 120.0, 120.0}, std::array{90.0, 120.0, 150.0}, std::array{10.0, 20.0, 330.0},
        std::array{250.0, 60.0, 50.0}, std::array{1.0, 179.0, 180.0}}) {
    const JunctionAngles angles = junction_angles(triple_junction(degrees).mesh);
    EXPECT_EQ(angles.edges, 6U);
    ASSERT_TRUE(angles.rms_deviation_deg && angles.outer_mean_deg);
    EXPECT_NEAR(*angles.rms_deviation_deg, rms(degrees[0], degrees[1], degrees[2]), 1e-11);
    EXPECT_NEAR(*angles.outer_mean_deg, degrees[0], 1e-11) << "region 0 is the air";
  }
}

TEST(JunctionAngles, DoNotDependOnTheTriangulationOrOnWhereOneStands) {
  const std::array degrees{100.0, 125.0, 135.0};
  SurfaceMesh mesh = triple_junction(degrees, 1, 3).mesh;
  EXPECT_NEAR(*junction_angles(mesh).rms_deviation_deg, rms(100, 125, 135), 1e-11);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(1.2, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  for (Vertex v : mesh.vertices()) mesh.set_position(v, turn * mesh.position(v));
  EXPECT_NEAR(*junction_angles(mesh).rms_deviation_deg, rms(100, 125, 135), 1e-11);
  for (Triangle t : mesh.triangles()) mesh.set_labels(t, mesh.labels(t));
  EXPECT_NEAR(*junction_angles(mesh).outer_mean_deg, 100, 1e-11);
}

TEST(JunctionAngles, AThousandRadiiAwayAreTheSame) {
  SurfaceMesh mesh = double_bubble(16);
  const JunctionAngles here = junction_angles(mesh);
  for (Vertex v : mesh.vertices()) mesh.set_position(v, mesh.position(v) + Vec3(1000, -1000, 1000));
  const JunctionAngles there = junction_angles(mesh);
  EXPECT_NEAR(*there.rms_deviation_deg, *here.rms_deviation_deg, 1e-9);
  EXPECT_NEAR(*there.outer_mean_deg, *here.outer_mean_deg, 1e-9);
}

TEST(JunctionAngles, AreTheSameToTheBitWhenScaledByAPowerOfTwo) {
  SurfaceMesh mesh = double_bubble(16);
  const JunctionAngles one = junction_angles(mesh);
  for (Vertex v : mesh.vertices()) mesh.set_position(v, std::ldexp(1.0, -40) * mesh.position(v));
  const JunctionAngles small = junction_angles(mesh);
  EXPECT_EQ(*small.rms_deviation_deg, *one.rms_deviation_deg);
  EXPECT_EQ(*small.outer_mean_deg, *one.outer_mean_deg);
}

TEST(JunctionAngles, OfTheStartShapeTendToThoseOfTheTwoSpheres) {
  // The spheres overlap by 22.5° and leave the wall at 180° − 22.5° each; a ring's chord takes half of its 180°/n off
  // either angle.
  for (long n : {16L, 96L}) {
    const JunctionAngles angles = junction_angles(double_bubble(n));
    EXPECT_EQ(angles.edges, static_cast<std::size_t>(n));
    EXPECT_NEAR(*angles.outer_mean_deg, 45 + 180.0 / static_cast<double>(n), 16.0 / static_cast<double>(n)) << n;
  }
}

TEST(JunctionAngles, WithoutJunctionsThereAreNone) {
  const JunctionAngles angles = junction_angles(icosphere(1));
  EXPECT_FALSE(angles.rms_deviation_deg);
  EXPECT_FALSE(angles.outer_mean_deg);
  EXPECT_EQ(angles.edges, 0U);
}

TEST(JunctionAngles, WithoutAirThereIsNoOuterOne) {
  SurfaceMesh mesh = triple_junction({120, 120, 120}).mesh;
  for (Triangle t : mesh.triangles()) {
    auto labels = mesh.labels(t);
    mesh.set_labels(t, {Region(labels.p.index() + 1), Region(labels.q.index() + 1)});
  }
  EXPECT_FALSE(junction_angles(mesh).outer_mean_deg);
  EXPECT_NEAR(*junction_angles(mesh).rms_deviation_deg, 0, 1e-11);
}

TEST(JunctionAngles, EdgesOfFourFilmsAreLeftOut) {
  auto junction = triple_junction({120, 120, 120});
  // A fourth film at the middle edge of the border.
  const Vertex top = junction.mesh.add_vertex({0.5, 5, 5});
  junction.mesh.add_triangle(junction.border[3], junction.border[4], top, {Region(1), Region(7)});
  EXPECT_EQ(junction_angles(junction.mesh).edges, 5U);
}

}  // namespace
}  // namespace foamsim
