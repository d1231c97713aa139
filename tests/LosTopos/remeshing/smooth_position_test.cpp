#include "LosTopos/remeshing/smooth_position.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "LosTopos/mesh/measures.h"
#include "LosTopos/shapes/solids.h"
#include "tests/LosTopos/remeshing/patches.h"
#include "tests/support/film_meshes.h"

namespace lostopos {
namespace {

double rim_error(long segments) {
  const SurfaceMesh mesh = test::analytic_double_bubble(1, segments);
  const Edge e = test::first_edge(mesh, [&](Edge f) { return mesh.is_junction(f); });
  const auto x = border_position(mesh, e);
  return x ? std::abs(x->norm() - std::numbers::sqrt3 / 2) : 1;
}

TEST(BorderPosition, IsOfFourthOrderOnACircle) {
  EXPECT_LT(rim_error(24), 1e-4);
  EXPECT_NEAR(rim_error(24) / rim_error(48), 16, 1);
}

TEST(BorderPosition, IsTheMidpointOnAStraightLine) {
  const auto cube = test::cube_frame(4);
  const Edge e = test::first_edge(cube.mesh, [&](Edge f) {
    return cube.mesh.is_junction(f) && cube.mesh.vertices(f)[0] != Vertex(0) && cube.mesh.vertices(f)[1] != Vertex(0);
  });
  const auto x = border_position(cube.mesh, e);
  ASSERT_TRUE(x.has_value());
  const auto [a, b] = cube.mesh.vertices(e);
  EXPECT_LT((*x - 0.5 * (cube.mesh.position(a) + cube.mesh.position(b))).norm(), 1e-15);
}

TEST(ButterflyPosition, IsTheMidpointOnAFlatRegularPatch) {
  const SurfaceMesh mesh = test::hexagonal_patch(3);
  const Edge e = mesh.edges(Vertex(0))[0];
  const auto x = butterfly_position(mesh, e);
  ASSERT_TRUE(x.has_value());
  const auto [a, b] = mesh.vertices(e);
  EXPECT_LT((*x - 0.5 * (mesh.position(a) + mesh.position(b))).norm(), 1e-15);
}

TEST(ButterflyPosition, IsFarBetterThanTheMidpointOnASphere) {
  // Both kinds of stencil: an icosphere has twelve vertices of valence five.
  double last = 0;
  for (long level : {2L, 3L, 4L}) {
    const SurfaceMesh mesh = icosphere(level);
    double worst = 0, worst_midpoint = 0;
    for (Edge e : mesh.edges()) {
      const auto x = butterfly_position(mesh, e);
      ASSERT_TRUE(x.has_value());
      worst = std::max(worst, std::abs(x->norm() - 1));
      const auto [a, b] = mesh.vertices(e);
      worst_midpoint = std::max(worst_midpoint, 1 - 0.5 * (mesh.position(a) + mesh.position(b)).norm());
    }
    EXPECT_LT(worst, 0.25 * worst_midpoint);
    if (last > 0) {
      EXPECT_GT(last / worst, 3.9) << "second order at the vertices of valence five";
    }
    last = worst;
  }
}

TEST(ButterflyPosition, NeedsTheWholeFan) {
  const SurfaceMesh mesh = test::hexagonal_patch(1);
  for (Edge e : mesh.edges()) EXPECT_FALSE(butterfly_position(mesh, e).has_value());
  const SurfaceMesh bubble = test::analytic_double_bubble(1, 12);
  for (Edge e : bubble.edges())
    for (Vertex v : bubble.vertices(e))
      if (bubble.is_junction(v)) {
        EXPECT_FALSE(butterfly_position(bubble, e).has_value());
      }
}

}  // namespace
}  // namespace lostopos
