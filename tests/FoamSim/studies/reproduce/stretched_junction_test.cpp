// The report's motivating experiment (its figure on the stretched junction): three flat films meet in a border; the
// triangles of one of them are stretched within their own plane. No angle changes, so no force may appear.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "FoamSim/effects/surface_tension.h"
#include "FoamSim/sheet/pressure/curvature.h"
#include "FoamSim/sheet/pressure/edge_angle.h"
#include "FoamSim/sheet/pressure/vertex_area/registry.h"
#include "FoamSim/sheet/sheet_velocity.h"
#include "FoamSim/sheet/velocity/registry.h"
#include "tests/support/sample_meshes.h"

namespace foamsim {
namespace {

using lostopos::Region;
using lostopos::Vec3;
using lostopos::Vertex;
using lostopos::test::triple_junction;
using lostopos::test::TripleJunction;
using std::numbers::pi;

// Film 1 lies between regions 1 and 2; region 0 is on the other side of the border from it.
constexpr int kStretched = 1;
constexpr std::array<double, 3> kBalanced{120, 120, 120}, kUnbalanced{100, 125, 135};
const VertexAreaOptions kOptions{.phi = 0.5, .resolution = 1};

// H of regions 0, 1, 2 at the middle of the border.
std::array<double, 3> curvatures(std::string_view area, const std::array<double, 3>& degrees, double stretch) {
  const TripleJunction junction = triple_junction(degrees, kStretched, stretch);
  SurfaceGeometry geometry;
  geometry.update(junction.mesh);
  CurvatureField field;
  field.update(junction.mesh, geometry, EdgeAngleCurvature(make_vertex_area(area, kOptions)));
  const auto h = field.at(geometry, junction.border[3]);
  return {h[0], h[1], h[2]};
}

double spread(const std::array<double, 3>& h) {
  const auto [low, high] = std::ranges::minmax(h);
  return high - low;
}

// What angles alone decide: how the sum of the three is shared out.
std::array<double, 3> shares(const std::array<double, 3>& h) {
  const double sum = std::accumulate(h.begin(), h.end(), 0.0);
  return {h[0] / sum, h[1] / sum, h[2] / sum};
}

TEST(StretchedJunction, IsInBalanceBeforeItIsStretched) {
  for (const VertexAreaEntry& entry : vertex_area_strategies()) {
    const auto h = curvatures(entry.name, kBalanced, 1);
    // Two edges of length 1 turn by 60° each; every region's area at the vertex is 1, for all three strategies here.
    for (double value : h) EXPECT_NEAR(value, pi / 3, 1e-14) << entry.name;
  }
}

TEST(StretchedJunction, NaiveCurvatureLosesTheBalance) {
  for (double stretch : {1.5, 2.0, 4.0}) {
    const auto h = curvatures("naive", kBalanced, stretch);
    EXPECT_NEAR(h[0], pi / 3, 1e-14) << "the region that the film does not bound notices nothing";
    EXPECT_NEAR(h[1], pi / 3 * 2 / (1 + stretch), 1e-14);
    EXPECT_NEAR(h[2], pi / 3 * 2 / (1 + stretch), 1e-14);
    EXPECT_NEAR(spread(h), pi / 3 * (stretch - 1) / (stretch + 1), 1e-14);
  }
  EXPECT_NEAR(spread(curvatures("naive", kBalanced, 2)), 0.34907, 1e-5) << "a third of the curvature itself";
}

TEST(StretchedJunction, ConstantEdgeAndAveragedCurvatureKeepTheBalance) {
  for (double stretch : {1.5, 2.0, 4.0}) {
    const auto constant = curvatures("constant-edge", kBalanced, stretch);
    const auto averaged = curvatures("averaged", kBalanced, stretch);
    EXPECT_LT(spread(constant), 1e-14);
    EXPECT_LT(spread(averaged), 1e-14);
    EXPECT_NEAR(constant[0], pi / 3, 1e-14) << "blind to the triangles";
    EXPECT_NEAR(averaged[0], pi / 3 * 3 / (2 + stretch), 1e-14) << "follows the triangles, for all regions alike";
  }
}

TEST(StretchedJunction, WithUnequalAnglesTheForcesDirectionIsThatOfTheAnglesButForNaive) {
  for (double stretch : {1.0, 2.0, 4.0})
    for (std::string_view area : {"constant-edge", "averaged"}) {
      const auto share = shares(curvatures(area, kUnbalanced, stretch));
      for (std::size_t r = 0; r < 3; ++r) EXPECT_NEAR(share[r], 1 - kUnbalanced[r] / 180, 1e-13) << area << stretch;
    }
  const auto before = shares(curvatures("naive", kUnbalanced, 1)), after = shares(curvatures("naive", kUnbalanced, 2));
  for (std::size_t r = 0; r < 3; ++r) EXPECT_NEAR(before[r], 1 - kUnbalanced[r] / 180, 1e-13);
  EXPECT_GT(after[0] - before[0], 0.1) << "region 0 seems to push harder";
}

// Circulation after one step of tension from rest, and the velocity that it gives the middle of the border.
struct FirstStep {
  double circulation[3];  // Γ^{01}, Γ^{12}, Γ^{20} at the middle of the border
  Vec3 velocity;
};

FirstStep first_step(std::string_view area, double stretch) {
  TripleJunction junction = triple_junction(kBalanced, kStretched, stretch);
  SurfaceGeometry geometry;
  geometry.update(junction.mesh);
  CirculationField circulation(junction.mesh);
  SurfaceTension tension(1, std::make_unique<EdgeAngle>(make_vertex_area(area, kOptions)));
  tension.update_circulation({junction.mesh, geometry, 0, 0.01}, circulation);
  std::vector<SheetTriangle> sheet;
  gather_sheet(junction.mesh, circulation, sheet);
  std::vector<Vec3> u(junction.mesh.vertex_slots());
  SheetVelocity(make_biot_savart("direct"))
      .evaluate(sheet, junction.mesh.positions(), junction.mesh.positions(), 0.75, u);
  const Vertex middle = junction.border[3];
  const Region r0(0), r1(1), r2(2);
  return {{circulation.get(middle, {r0, r1}), circulation.get(middle, {r1, r2}), circulation.get(middle, {r2, r0})},
          u[middle.index()]};
}

TEST(StretchedJunction, NaiveForcesDriveTheBorderAcrossTheStretchedFilm) {
  const FirstStep naive = first_step("naive", 2);
  EXPECT_NEAR(naive.circulation[0], 0.01 * 0.34907, 1e-7);
  EXPECT_NEAR(naive.circulation[1], 0, 1e-16) << "between the two regions that are affected alike";
  EXPECT_NEAR(naive.circulation[2], -0.01 * 0.34907, 1e-7);
  const Vec3 along_film = triple_junction(kBalanced).direction[kStretched];
  EXPECT_GT(std::abs(naive.velocity.dot(along_film)), 1e-4);
  EXPECT_NEAR((naive.velocity - naive.velocity.dot(along_film) * along_film).norm() / naive.velocity.norm(), 0, 0.05);
}

TEST(StretchedJunction, BalancedStrategiesLeaveTheBorderAtRest) {
  const double naive_speed = first_step("naive", 2).velocity.norm();
  for (std::string_view area : {"constant-edge", "averaged"})
    for (double stretch : {1.0, 2.0, 4.0}) {
      const FirstStep step = first_step(area, stretch);
      for (double gamma : step.circulation) EXPECT_NEAR(gamma, 0, 1e-15) << area;
      EXPECT_LT(step.velocity.norm(), 1e-12 * naive_speed) << area;
    }
}

}  // namespace
}  // namespace foamsim
