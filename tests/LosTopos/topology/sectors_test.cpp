#include "LosTopos/topology/sectors.h"

#include <gtest/gtest.h>

#include "LosTopos/mesh/audit.h"
#include "LosTopos/mesh/measures.h"
#include "LosTopos/shapes/solids.h"
#include "tests/LosTopos/topology/clusters.h"
#include "tests/support/film_meshes.h"

namespace lostopos {
namespace {

TEST(Sectors, AFilmHasTwoAndAPlateauBorderThree) {
  const SurfaceMesh mesh = test::analytic_double_bubble(1, 12);
  for (Vertex v : mesh.vertices()) {
    EXPECT_TRUE(is_complete(mesh, v));
    const Neighbourhood around = neighbourhood(mesh, v);
    EXPECT_TRUE(around.consistent);
    EXPECT_EQ(around.parts.size(), 1u);
    EXPECT_EQ(around.sectors.size(), mesh.is_junction(v) ? 3u : 2u);
  }
}

// Six regions meet at the centre, and those on opposite sides of the cube have no film between them.
TEST(Sectors, TheCentreOfACubeFrameMissesThreeFilms) {
  const auto cube = test::cube_frame(3);
  const Vertex centre(0);
  EXPECT_FALSE(is_complete(cube.mesh, centre));
  const Neighbourhood around = neighbourhood(cube.mesh, centre);
  ASSERT_EQ(around.sectors.size(), 6u);
  for (const Sector& sector : around.sectors) EXPECT_EQ(sector.triangles.size(), 4u);
}

TEST(Sectors, ALineOfFourFilmsIsIncomplete) {
  const SurfaceMesh mesh = test::four_columns({Region(1), Region(2), Region(3), Region(4)});
  ASSERT_EQ(audit(mesh).text(), "clean");
  std::size_t incomplete = 0;
  for (Vertex v : mesh.vertices()) incomplete += is_complete(mesh, v) ? 0 : 1;
  // The line of length 1 is divided in two. At its ends the air joins in.
  EXPECT_EQ(incomplete, 3u);
}

// A region that is there twice, with the air between, is two sectors.
TEST(Sectors, OneRegionCanBeSeveralSectors) {
  const SurfaceMesh mesh = test::four_columns({Region(1), Region(2), Region(1), Region(3)});
  for (Vertex v : mesh.vertices()) {
    const Vec3& x = mesh.position(v);
    if (x[0] != 0 || x[1] != 0) continue;
    EXPECT_FALSE(is_complete(mesh, v));
    EXPECT_EQ(neighbourhood(mesh, v).sectors.size(), x[2] > 0 && x[2] < 1 ? 4u : 5u);
  }
}

TEST(Sectors, APinchedVertexHasTwoParts) {
  SurfaceMesh mesh;
  const Vertex tip = mesh.add_vertex({0, 0, 0});
  for (double side : {-1.0, 1.0}) {
    std::array<Vertex, 3> base;
    for (std::size_t i = 0; i < 3; ++i) {
      const double angle = 2.1 * static_cast<double>(i);
      base[i] = mesh.add_vertex({std::cos(angle), std::sin(angle), side});
    }
    const Region region(side < 0 ? 1u : 2u);
    const bool up = side > 0;
    mesh.add_triangle(base[0], base[1], base[2], up ? Labels{region, air} : Labels{air, region});
    for (std::size_t i = 0; i < 3; ++i)
      mesh.add_triangle(tip, base[i], base[(i + 1) % 3], up ? Labels{air, region} : Labels{region, air});
  }
  ASSERT_EQ(audit(mesh).text(), "clean");
  EXPECT_FALSE(is_complete(mesh, tip));
  EXPECT_EQ(neighbourhood(mesh, tip).parts.size(), 2u);
}

}  // namespace
}  // namespace lostopos
