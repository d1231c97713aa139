#include "FoamSim/sheet/bubble_volumes.h"

#include <gtest/gtest.h>

#include <numbers>

#include "FoamSim/scenes/shapes/double_bubble.h"
#include "FoamSim/sheet/area_gradient.h"
#include "LosTopos/mesh/measures.h"
#include "LosTopos/shapes/solids.h"

namespace foamsim {
namespace {

using lostopos::SurfaceMesh;
using lostopos::Vec3;
using lostopos::Vertex;

bool all_free(Vertex /*v*/) {
  return true;
}

TEST(BubbleVolumes, OfClosedBubblesAreWhatTheyHold) {
  const auto bubbles = closed_bubbles(double_bubble(12));
  ASSERT_EQ(bubbles.size(), 2U);
  const SurfaceMesh ball = lostopos::icosphere(3);
  EXPECT_NEAR(closed_bubbles(ball).begin()->second, 4 * std::numbers::pi / 3, 0.05);
}

// The product of the gradients with a small motion is the volumes' change, to second order.
TEST(BubbleVolumes, HaveTheGradientsThatMotionsShow) {
  const SurfaceMesh mesh = double_bubble(12);
  BubbleVolumes bubbles(mesh, closed_bubbles(mesh));
  const std::vector<Vec3> x(mesh.positions().begin(), mesh.positions().end());
  ASSERT_TRUE(bubbles.update(x, all_free));
  // One direction for each vertex, times its area, which the product divides by.
  std::vector<Vec3> weighted(x.size(), Vec3::Zero()), plus = x, minus = x;
  constexpr double small = 1e-5;
  for (Vertex v : mesh.vertices()) {
    const double i = v.index();
    const Vec3 direction(std::sin(i), std::cos(2 * i), std::sin(3 * i + 1));
    double area = 0;
    for (lostopos::Triangle t : mesh.triangles(v)) area += lostopos::area(mesh, t) / 3;
    weighted[v.index()] = area * direction;
    plus[v.index()] += small * direction;
    minus[v.index()] -= small * direction;
  }
  const Eigen::VectorXd slope = (bubbles.missing(minus) - bubbles.missing(plus)) / (2 * small);
  const Eigen::VectorXd product = bubbles.product(weighted);
  for (Eigen::Index r = 0; r < 2; ++r) EXPECT_NEAR(product[r], slope[r], 1e-6 * std::abs(slope[r]) + 1e-9);
}

// Of a ball: ∂E/∂x is balanced by the pressure 2 T/R, but for its facets.
TEST(BubbleVolumes, HaveThePressuresOfLaplace) {
  const SurfaceMesh ball = lostopos::icosphere(4);
  BubbleVolumes bubbles(ball, closed_bubbles(ball));
  const std::vector<Vec3> x(ball.positions().begin(), ball.positions().end());
  ASSERT_TRUE(bubbles.update(x, all_free));
  std::vector<Vec3> gradient(x.size(), Vec3::Zero());
  add_area_gradient(ball, {}, x, 3.0, gradient);
  const Eigen::VectorXd pressure = bubbles.solve(bubbles.product(gradient));
  ASSERT_EQ(pressure.size(), 1);
  EXPECT_NEAR(pressure[0], 2 * 3.0, 0.02);
  double before = 0, after = 0;
  for (const Vec3& g : gradient) before += g.squaredNorm();
  bubbles.add(-pressure, false, gradient);
  for (const Vec3& g : gradient) after += g.squaredNorm();
  EXPECT_LT(after, 1e-4 * before);
}

}  // namespace
}  // namespace foamsim
