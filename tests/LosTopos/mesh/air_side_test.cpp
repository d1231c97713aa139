#include "LosTopos/mesh/air_side.h"

#include <gtest/gtest.h>

#include "LosTopos/mesh/measures.h"
#include "LosTopos/shapes/solids.h"
#include "LosTopos/shapes/voronoi_foam.h"

namespace lostopos {
namespace {

TEST(AirSide, NormalsOfASphereAreRadialWhicheverWayItsTrianglesTurn) {
  const SurfaceMesh sphere = icosphere(3);
  SurfaceMesh turned;
  for (Vertex v : sphere.vertices()) turned.add_vertex(sphere.position(v));
  for (Triangle t : sphere.triangles()) {
    const auto [a, b, c] = sphere.vertices(t);
    turned.add_triangle(a, c, b, {air, Region(1)});
  }
  for (Vertex v : sphere.vertices()) {
    EXPECT_GT(air_side_normal(sphere, v).dot(sphere.position(v)), 0.999);
    EXPECT_NEAR((air_side_normal(turned, v) - air_side_normal(sphere, v)).norm(), 0, 1e-12);
  }
  EXPECT_NEAR(area_by_side(sphere).air_side, total_area(sphere), 1e-12);
  EXPECT_EQ(area_by_side(sphere).shared, 0);
}

TEST(AirSide, OnlyTheWallsOfAFoamHaveOne) {
  const SurfaceMesh foam = voronoi_foam({.cells = 5, .seed = 3, .subdivisions = 1});
  std::size_t inside = 0;
  for (Vertex v : foam.vertices()) {
    const Vec3& x = foam.position(v);
    const Vec3 normal = air_side_normal(foam, v);
    int walls = 0;
    for (int i = 0; i < 3; ++i) {
      if (x[i] != 0 && x[i] != 1) {
        EXPECT_EQ(normal[i], 0);
        continue;
      }
      ++walls;
      EXPECT_GT(x[i] == 0 ? -normal[i] : normal[i], 0);
    }
    inside += walls == 0;
    EXPECT_NEAR(normal.norm(), walls == 0 ? 0 : 1, 1e-12);
  }
  EXPECT_GT(inside, 0u);
  EXPECT_NEAR(area_by_side(foam).air_side, 6, 1e-12);
  EXPECT_NEAR(area_by_side(foam).air_side + area_by_side(foam).shared, total_area(foam), 1e-12);
}

}  // namespace
}  // namespace lostopos
