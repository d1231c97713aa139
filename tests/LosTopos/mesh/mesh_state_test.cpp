#include <gtest/gtest.h>

#include "LosTopos/error.h"
#include "LosTopos/mesh/audit.h"
#include "LosTopos/mesh/surface_mesh.h"
#include "tests/support/sample_meshes.h"

namespace lostopos {
namespace {

template <class H>
std::vector<std::uint32_t> indices(std::span<const H> handles) {
  std::vector<std::uint32_t> result;
  for (H h : handles) result.push_back(h.index());
  return result;
}

// Slots, gaps, positions, labels and the order of all incidence lists.
void expect_same_to_the_bit(const SurfaceMesh& a, const SurfaceMesh& b) {
  ASSERT_EQ(a.vertex_slots(), b.vertex_slots());
  ASSERT_EQ(a.edge_slots(), b.edge_slots());
  ASSERT_EQ(a.triangle_slots(), b.triangle_slots());
  for (std::size_t i = 0; i < a.vertex_slots(); ++i) {
    const Vertex v(i);
    ASSERT_EQ(a.alive(v), b.alive(v));
    EXPECT_EQ(a.position(v), b.position(v));
    EXPECT_EQ(indices(a.edges(v)), indices(b.edges(v)));
    EXPECT_EQ(indices(a.triangles(v)), indices(b.triangles(v)));
  }
  for (std::size_t i = 0; i < a.edge_slots(); ++i) {
    const Edge e(i);
    ASSERT_EQ(a.alive(e), b.alive(e));
    EXPECT_EQ(a.vertices(e), b.vertices(e));
    EXPECT_EQ(indices(a.triangles(e)), indices(b.triangles(e)));
  }
  for (std::size_t i = 0; i < a.triangle_slots(); ++i) {
    const Triangle t(i);
    ASSERT_EQ(a.alive(t), b.alive(t));
    EXPECT_EQ(a.vertices(t), b.vertices(t));
    EXPECT_EQ(a.edges(t), b.edges(t));
    EXPECT_EQ(a.labels(t), b.labels(t));
  }
}

// Dead slots of every kind.
SurfaceMesh mesh_with_gaps() {
  SurfaceMesh mesh = test::triple_junction({120, 120, 120}).mesh;
  for (std::size_t i = 5; i < mesh.triangle_slots(); i += 4) mesh.remove_triangle(Triangle(i));
  for (Vertex v : {Vertex(0), Vertex(10), Vertex(40)}) {
    while (!mesh.triangles(v).empty()) mesh.remove_triangle(mesh.triangles(v)[0]);
    mesh.remove_vertex(v);
  }
  return mesh;
}

TEST(MeshState, RoundTripIsExact) {
  const SurfaceMesh mesh = mesh_with_gaps();
  expect_same_to_the_bit(mesh, SurfaceMesh::from_state(mesh.state()));
}

TEST(MeshState, AMeshFromAStateGoesOnLikeTheOriginal) {
  SurfaceMesh original = mesh_with_gaps();
  SurfaceMesh restored = SurfaceMesh::from_state(original.state());
  for (SurfaceMesh* mesh : {&original, &restored}) {
    const Vertex a = mesh->add_vertex({7, 0, 0}), b = mesh->add_vertex({8, 0, 0}), c = mesh->add_vertex({7, 1, 0});
    mesh->add_triangle(a, b, c, {Region(1), air});
  }
  expect_same_to_the_bit(original, restored);
}

TEST(MeshState, CloneIsIndependent) {
  SurfaceMesh mesh = test::corner_tetrahedron();
  SurfaceMesh copy = mesh.clone();
  expect_same_to_the_bit(mesh, copy);
  copy.set_position(Vertex(0), {9, 9, 9});
  copy.remove_triangle(Triangle(0));
  EXPECT_EQ(mesh.position(Vertex(0)), Vec3(0, 0, 0));
  EXPECT_EQ(mesh.triangle_count(), 4U);
}

TEST(MeshState, CompactionKeepsTheSurface) {
  SurfaceMesh mesh = mesh_with_gaps();
  const std::size_t vertices = mesh.vertex_count(), edges = mesh.edge_count(), triangles = mesh.triangle_count();
  std::vector<std::array<Vec3, 3>> before;
  for (Triangle t : mesh.triangles())
    before.push_back(
        {mesh.position(mesh.vertices(t)[0]), mesh.position(mesh.vertices(t)[1]), mesh.position(mesh.vertices(t)[2])});
  mesh.compact();
  EXPECT_EQ(mesh.vertex_slots(), vertices);
  EXPECT_EQ(mesh.edge_slots(), edges);
  ASSERT_EQ(mesh.triangle_slots(), triangles);
  for (std::size_t i = 0; i < triangles; ++i)
    for (int k = 0; k < 3; ++k)
      EXPECT_EQ(mesh.position(mesh.vertices(Triangle(i))[k]), before[i][k]) << "triangles keep their order";
  EXPECT_FALSE(audit(mesh, {.intersections = false, .closed_regions = false}).has(Defect::broken_incidence));
}

TEST(MeshState, ArraysOfDifferentLengthAreRefused) {
  auto state = test::corner_tetrahedron().state();
  state.labels.pop_back();
  EXPECT_THROW(SurfaceMesh::from_state(state), MeshError);
}

TEST(MeshState, ReferencesToElementsThatDoNotExistAreRefused) {
  const auto good = test::corner_tetrahedron().state();
  auto state = good;
  state.triangle_vertices[2][1] = Vertex(40);
  EXPECT_THROW(SurfaceMesh::from_state(state), MeshError);
  state = good;
  state.edge_triangles[0].push_back(Triangle(40));
  EXPECT_THROW(SurfaceMesh::from_state(state), MeshError);
  state = good;
  state.vertex_edges[3][0] = Edge(40);
  EXPECT_THROW(SurfaceMesh::from_state(state), MeshError);
}

}  // namespace
}  // namespace lostopos
