#include "FoamSim/sheet/sheet_velocity.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "FoamSim/scenes/shapes/double_bubble.h"
#include "FoamSim/scenes/shapes/solids.h"
#include "FoamSim/sheet/velocity/registry.h"
#include "LosTopos/mesh/measures.h"

namespace foamsim {
namespace {

using lostopos::air;
using lostopos::Labels;
using lostopos::Region;
using lostopos::SurfaceMesh;
using lostopos::Triangle;
using lostopos::Vec3;
using lostopos::Vertex;

constexpr Labels kFilm{Region(1), air};

TEST(SheetStrength, IsTheNormalCrossTheJumpOfTheVelocity) {
  // The potential jumps by 2Γ: for Γ = g·x the velocity jumps by the part of 2g in the plane.
  const std::array<Vec3, 3> x{Vec3(0.3, -1, 0.2), Vec3(1.5, 0.1, -0.4), Vec3(-0.2, 0.8, 1.1)};
  const Vec3 g(0.7, -1.3, 0.4);
  const Vec3 area_vector = 0.5 * (x[1] - x[0]).cross(x[2] - x[0]);
  const Vec3 strength = sheet_strength(x, {g.dot(x[0]), g.dot(x[1]), g.dot(x[2])});
  EXPECT_LT((strength - area_vector.cross(2 * g)).norm(), 1e-15);
}

TEST(SheetStrength, DoesNotSeeAConstant) {
  const std::array<Vec3, 3> x{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  EXPECT_EQ(sheet_strength(x, {4, 4, 4}), Vec3(0, 0, 0));
  EXPECT_EQ(sheet_strength(x, {1, 2, 3}), sheet_strength(x, {5, 6, 7}));
}

TEST(SheetStrength, IsTheSameHoweverATriangleIsWrittenDown) {
  SurfaceMesh one, other;
  for (SurfaceMesh* mesh : {&one, &other})
    for (const Vec3& x : {Vec3(0, 0, 0), Vec3(1, 0, 0.5), Vec3(0, 1, 0)}) mesh->add_vertex(x);
  one.add_triangle(Vertex(0), Vertex(1), Vertex(2), kFilm);
  other.add_triangle(Vertex(2), Vertex(1), Vertex(0), kFilm.flipped());
  std::vector<Vec3> strengths;
  for (SurfaceMesh* mesh : {&one, &other}) {
    CirculationField circulation(*mesh);
    for (Vertex v : mesh->vertices()) circulation.set(v, kFilm, v.index() * v.index() + 1.0);
    std::vector<SheetTriangle> sheet;
    gather_sheet(*mesh, circulation, sheet);
    VortexSources sources;
    fill_vortex_sources(sheet, mesh->positions(), sources);
    strengths.emplace_back(sources.gx[0], sources.gy[0], sources.gz[0]);
    EXPECT_LT((Vec3(sources.x[0], sources.y[0], sources.z[0]) - Vec3(1.0 / 3, 1.0 / 3, 0.5 / 3)).norm(), 1e-16);
  }
  EXPECT_EQ(strengths[0], strengths[1]);
}

// Largest error of the normal velocity on the unit sphere whose potential jump belongs to the normal velocity
// P_n(cos θ): inside φ = r^n P_n / n, outside φ = −r^{−n−1} P_n / (n + 1), hence 2Γ = −(1/n + 1/(n + 1)) P_n.
double normal_velocity_error(unsigned n, long subdivisions, double delta_over_h) {
  SurfaceMesh mesh = icosphere(subdivisions);
  CirculationField circulation(mesh);
  for (Vertex v : mesh.vertices())
    circulation.set(v, kFilm, -0.5 * (1.0 / n + 1.0 / (n + 1)) * std::legendre(n, mesh.position(v).x()));
  std::vector<SheetTriangle> sheet;
  gather_sheet(mesh, circulation, sheet);
  std::vector<Vec3> u(mesh.vertex_slots());
  SheetVelocity velocity(make_biot_savart("direct"));
  velocity.evaluate(sheet, mesh.positions(), mesh.positions(), delta_over_h * lostopos::mean_edge_length(mesh), u);
  EXPECT_EQ(velocity.evaluations(), 1);
  double largest = 0;
  for (Vertex v : mesh.vertices())
    largest = std::max(largest, std::abs(u[v.index()].dot(mesh.position(v)) - std::legendre(n, mesh.position(v).x())));
  return largest;
}

TEST(SheetVelocity, OfSphericalModesTendsToThatOfPotentialFlowAtFirstOrder) {
  for (unsigned n : {1U, 2U, 3U}) {
    const double coarse = normal_velocity_error(n, 2, 0.75), middle = normal_velocity_error(n, 3, 0.75),
                 fine = normal_velocity_error(n, 4, 0.75);
    EXPECT_GT(std::log2(coarse / middle), 0.75) << n;
    EXPECT_GT(std::log2(middle / fine), 0.85) << n;
    // The regularised kernel takes about 1 − exp(−(n + ½) δ) of mode n away.
    EXPECT_NEAR(fine, 1 - std::exp(-(n + 0.5) * 0.75 * 0.0755), 0.015) << n;
  }
}

TEST(SheetVelocity, InsideATranslatingSphereIsUniform) {
  SurfaceMesh mesh = icosphere(4);
  CirculationField circulation(mesh);
  for (Vertex v : mesh.vertices()) circulation.set(v, kFilm, -0.75 * mesh.position(v).x());
  std::vector<SheetTriangle> sheet;
  gather_sheet(mesh, circulation, sheet);
  const std::vector<Vec3> targets{{0, 0, 0}, {0.4, 0, 0}, {0, 0.3, -0.3}, {0, 2, 0}, {2, 0, 0}};
  std::vector<Vec3> u(targets.size());
  SheetVelocity(make_biot_savart("direct")).evaluate(sheet, mesh.positions(), targets, 0.01, u);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_LT((u[i] - Vec3(1, 0, 0)).norm(), 0.01) << i;
  // Outside: the dipole −cos θ / (2 r²).
  EXPECT_LT((u[3] - Vec3(-0.5 / 8, 0, 0)).norm(), 0.001);
  EXPECT_LT((u[4] - Vec3(1.0 / 8, 0, 0)).norm(), 0.001);
}

TEST(SheetVelocity, ConstantCirculationMovesNothing) {
  SurfaceMesh mesh = double_bubble(16);
  CirculationField circulation(mesh);
  for (Vertex v : mesh.vertices())
    for (PairCirculation& held : circulation.at(v)) held.value = 12.5;
  std::vector<SheetTriangle> sheet;
  gather_sheet(mesh, circulation, sheet);
  std::vector<Vec3> u(mesh.vertex_slots());
  SheetVelocity(make_biot_savart("direct")).evaluate(sheet, mesh.positions(), mesh.positions(), 0.1, u);
  for (const Vec3& velocity : u) EXPECT_LT(velocity.norm(), 1e-12);
}

}  // namespace
}  // namespace foamsim
