#include "LosTopos/remeshing/vertex_rank.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "tests/LosTopos/remeshing/patches.h"
#include "tests/support/film_meshes.h"

namespace lostopos {
namespace {

std::map<VertexRank, int> census(const SurfaceMesh& mesh) {
  std::map<VertexRank, int> counts;
  for (Vertex v : mesh.vertices()) ++counts[rank(mesh, v)];
  return counts;
}

TEST(VertexRank, ADoubleBubbleHasOneCircleOfBorderAndNoCorner) {
  auto counts = census(test::analytic_double_bubble(1, 12));
  EXPECT_EQ(counts[VertexRank::border], 12);
  EXPECT_EQ(counts[VertexRank::corner], 0);
}

TEST(VertexRank, OfACubeFrame) {
  const auto cube = test::cube_frame(4);
  auto counts = census(cube.mesh);
  // The centre and the cube's eight corners; three vertices on each of 8 lines and 12 free ends; 3 within each film.
  EXPECT_EQ(counts[VertexRank::corner], 9);
  EXPECT_EQ(counts[VertexRank::border], 20 * 3);
  EXPECT_EQ(counts[VertexRank::film], 12 * 3);
}

TEST(VertexRank, ACurveWhoseFilmsChangeHasACornerThere) {
  SurfaceMesh mesh = test::hexagonal_patch(1);
  // A fin along a straight line of two edges; its halves face different regions.
  const Vertex left(mesh.find_edge(Vertex(0), Vertex(1)).valid() ? 1 : 2);
  Vertex right;
  for (Vertex v : mesh.vertices())
    if ((mesh.position(v) + mesh.position(left)).norm() < 1e-9) right = v;
  ASSERT_TRUE(right.valid());
  const Vertex top = mesh.add_vertex({0, 0, 1});
  mesh.add_triangle(left, Vertex(0), top, {air, Region(2)});
  const Triangle second = mesh.add_triangle(Vertex(0), right, top, {air, Region(2)});
  EXPECT_EQ(rank(mesh, Vertex(0)), VertexRank::border);
  mesh.set_labels(second, {air, Region(3)});
  EXPECT_EQ(rank(mesh, Vertex(0)), VertexRank::corner);
}

}  // namespace
}  // namespace lostopos
