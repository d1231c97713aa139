#include "FoamSim/scenes/shapes/solids.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "LosTopos/mesh/audit.h"
#include "LosTopos/mesh/measures.h"

namespace foamsim {
namespace {

using lostopos::air;
using lostopos::Region;
using lostopos::SurfaceMesh;
using lostopos::Triangle;
using lostopos::Vec3;
using lostopos::Vertex;
using std::numbers::pi;

double volume(const SurfaceMesh& mesh) {
  return lostopos::region_volumes(mesh)[1].volume;
}

void expect_closed_bubble(const SurfaceMesh& mesh) {
  EXPECT_EQ(lostopos::audit(mesh).text(), "clean");
  EXPECT_EQ(lostopos::euler_characteristic(mesh), 2);
  for (Triangle t : mesh.triangles()) {
    EXPECT_EQ(mesh.labels(t), (lostopos::Labels{Region(1), air}));
    EXPECT_GT(lostopos::area_vector(mesh, t).dot(lostopos::barycentre(mesh, t)), 0) << "normals point outwards";
  }
}

TEST(Icosphere, IsAClosedSphere) {
  for (long n : {0L, 1L, 2L, 3L}) {
    const SurfaceMesh mesh = icosphere(n, 2.5);
    EXPECT_EQ(mesh.triangle_count(), 20U << (2 * n));
    expect_closed_bubble(mesh);
    for (Vertex v : mesh.vertices()) EXPECT_NEAR(mesh.position(v).norm(), 2.5, 1e-15 * 4);
  }
}

TEST(Icosphere, VolumeAndAreaConvergeAtSecondOrder) {
  double last = 0;
  for (long n : {2L, 3L, 4L}) {
    const SurfaceMesh mesh = icosphere(n);
    const double error = 4 * pi / 3 - volume(mesh);
    EXPECT_GT(error, 0);
    if (last > 0) {
      EXPECT_NEAR(last / error, 4, 0.1);
    }
    last = error;
  }
  EXPECT_NEAR(lostopos::total_area(icosphere(5)), 4 * pi, 0.01);
}

TEST(Tetrahedron, HasTheVolumeOfOne) {
  // Edge a = R √(8/3); volume a³ / (6 √2).
  const double edge = 2 * std::sqrt(8.0 / 3);
  for (long n : {0L, 1L, 3L}) {
    const SurfaceMesh mesh = tetrahedron(n, 2);
    EXPECT_EQ(mesh.triangle_count(), 4U << (2 * n));
    EXPECT_NEAR(volume(mesh), std::pow(edge, 3) / (6 * std::sqrt(2.0)), 1e-13);
    EXPECT_NEAR(lostopos::total_area(mesh), std::sqrt(3.0) * edge * edge, 1e-13);
    expect_closed_bubble(mesh);
  }
}

TEST(Cube, HasTheVolumeOfOne) {
  const double edge = 2 / std::sqrt(3.0);
  for (long n : {0L, 1L, 2L}) {
    const SurfaceMesh mesh = cube(n);
    EXPECT_EQ(mesh.triangle_count(), 12U << (2 * n));
    EXPECT_NEAR(volume(mesh), std::pow(edge, 3), 1e-14);
    EXPECT_NEAR(lostopos::total_area(mesh), 6 * edge * edge, 1e-13);
    expect_closed_bubble(mesh);
  }
}

TEST(PerturbWithMode, MovesAlongTheRadiusByTheLegendrePolynomial) {
  SurfaceMesh mesh = icosphere(2, 3);
  const SurfaceMesh before = icosphere(2, 3);
  perturb_with_mode(mesh, 3, 0.05);
  for (Vertex v : mesh.vertices()) {
    const Vec3 direction = before.position(v) / 3;
    const double x = direction.x(), p3 = (5 * x * x * x - 3 * x) / 2;
    EXPECT_LT((mesh.position(v) - 3 * (1 + 0.05 * p3) * direction).norm(), 1e-14);
  }
}

TEST(PerturbWithMode, KeepsTheVolumeToFirstOrder) {
  for (long mode : {1L, 2L, 4L}) {
    SurfaceMesh mesh = icosphere(4);
    const double before = volume(mesh);
    perturb_with_mode(mesh, mode, 0.01);
    EXPECT_NEAR(volume(mesh) / before, 1, 3 * 0.01 * 0.01) << mode;
  }
}

}  // namespace
}  // namespace foamsim
