// What no edge tells: bubbles turned inside out, on their own, in a cluster, within another; and surfaces that end at
// the walls of a box.
#include "LosTopos/mesh/region_lines.h"

#include <gtest/gtest.h>

#include "LosTopos/mesh/audit.h"
#include "LosTopos/mesh/measures.h"
#include "LosTopos/shapes/solids.h"
#include "LosTopos/shapes/voronoi_foam.h"
#include "tests/support/sample_meshes.h"

namespace lostopos {
namespace {

void turn(SurfaceMesh& mesh, Region region) {
  for (Triangle t : mesh.triangles())
    if (mesh.labels(t).has(region)) mesh.set_labels(t, mesh.labels(t).flipped());
}

TEST(InsideOut, ABubbleIsFoundThoughItsEdgesAgree) {
  for (long n : {0L, 2L}) {
    SurfaceMesh mesh = icosphere(n);
    EXPECT_EQ(audit(mesh).text(), "clean");
    turn(mesh, Region(1));
    EXPECT_LT(region_volumes(mesh)[1].volume, 0);
    EXPECT_TRUE(audit(mesh).has(Defect::inside_out)) << audit(mesh).text();
  }
}

TEST(InsideOut, OneOfTwoBubblesIsFound) {
  SurfaceMesh mesh;
  test::add_corner_tetrahedron(mesh, 1, {0, 0, 0}, Region(1), air);
  test::add_corner_tetrahedron(mesh, 0.3, {3, 0, 0}, air, Region(1));
  // The two volumes add up to more than nothing.
  EXPECT_GT(region_volumes(mesh)[1].volume, 0);
  EXPECT_TRUE(audit(mesh).has(Defect::inside_out)) << audit(mesh).text();
}

TEST(InsideOut, ABubbleWithinABubbleHasToKnowWhereItIs) {
  SurfaceMesh shell = test::globe(1, 12);
  test::add_corner_tetrahedron(shell, 0.3, {0, 0, 0}, air, Region(1));  // a hollow ball
  EXPECT_EQ(audit(shell).text(), "clean");
  SurfaceMesh lost = test::globe(1, 12);
  test::add_corner_tetrahedron(lost, 0.3, {0, 0, 0}, Region(2), air);  // in the air, it says, but it is in region 1
  EXPECT_TRUE(audit(lost).has(Defect::inside_out)) << audit(lost).text();
}

TEST(InsideOut, WithoutAirEitherSideMayBeOutside) {
  SurfaceMesh mesh;
  test::add_corner_tetrahedron(mesh, 1, {0, 0, 0}, Region(1), Region(2));
  EXPECT_EQ(audit(mesh).text(), "clean");
  test::add_corner_tetrahedron(mesh, 1, {3, 0, 0}, Region(2), Region(1));
  EXPECT_TRUE(audit(mesh).has(Defect::inside_out));
}

// A foam of which the box is not part, as mcf's files are; region 1 goes by the name of 0 there.
SurfaceMesh foam_without_walls() {
  SurfaceMesh mesh = voronoi_foam({.cells = 8, .seed = 3, .subdivisions = 1});
  std::vector<Triangle> walls;
  for (Triangle t : mesh.triangles())
    if (mesh.labels(t).has(air)) walls.push_back(t);
  for (Triangle t : walls) mesh.remove_triangle(t);
  const auto renamed = [](Region r) { return r == Region(1) ? air : r; };
  for (Triangle t : mesh.triangles()) mesh.set_labels(t, {renamed(mesh.labels(t).p), renamed(mesh.labels(t).q)});
  for (std::size_t v = 0; v < mesh.vertex_slots(); ++v)
    if (mesh.alive(Vertex(v)) && mesh.triangles(Vertex(v)).empty()) mesh.remove_vertex(Vertex(v));
  return mesh;
}

TEST(Walls, AreWhereFilmsMayEnd) {
  SurfaceMesh mesh = foam_without_walls();
  ASSERT_TRUE(ends_at_walls(mesh, {}));
  EXPECT_TRUE(audit(mesh).has(Defect::open_region));
  const AuditOptions in_box{.walls = BoxWalls{}};
  EXPECT_EQ(audit(mesh, in_box).text(), "clean");
  for (Triangle t : mesh.triangles()) mesh.set_labels(t, mesh.labels(t).flipped());
  EXPECT_FALSE(audit(mesh, in_box).clean());
}

TEST(Walls, AHoleInAFilmIsNoneOfTheirs) {
  SurfaceMesh mesh = foam_without_walls();
  for (Triangle t : mesh.triangles()) {
    const auto& [a, b, c] = mesh.vertices(t);
    if (walls_at({}, mesh.position(a)) != Hold::none || walls_at({}, mesh.position(b)) != Hold::none ||
        walls_at({}, mesh.position(c)) != Hold::none)
      continue;
    mesh.remove_triangle(t);
    break;
  }
  EXPECT_FALSE(ends_at_walls(mesh, {}));
  EXPECT_TRUE(audit(mesh, {.walls = BoxWalls{}}).has(Defect::open_region));
}

TEST(Walls, VerticesArePutOnThemAndTrianglesInThemGo) {
  SurfaceMesh mesh = foam_without_walls();
  const std::size_t before = mesh.triangle_count();
  const Vertex a = mesh.add_vertex({0.2, 3e-7, 0.2}), b = mesh.add_vertex({0.4, -2e-3, 0.2}),
               c = mesh.add_vertex({0.2, 0, 0.4});
  (void)mesh.add_triangle(a, b, c, {Region(2), Region(3)});
  for (Vertex v : {a, b}) mesh.set_position(v, put_on_walls({}, mesh.position(v)));
  EXPECT_EQ(mesh.position(a).y(), 0);
  EXPECT_EQ(mesh.position(b).y(), 0);
  EXPECT_EQ(remove_triangles_in_walls(mesh, {}), 1u);
  EXPECT_EQ(mesh.triangle_count(), before);
  EXPECT_FALSE(mesh.alive(a));
}

}  // namespace
}  // namespace lostopos
