#include "LosTopos/mesh/attribute.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>

#include "LosTopos/mesh/audit.h"
#include "LosTopos/mesh/surface_mesh.h"
#include "tests/support/sample_meshes.h"

namespace lostopos {
namespace {

TEST(Attribute, HasItsInitialValueForElementsOldAndNew) {
  SurfaceMesh mesh = test::corner_tetrahedron();
  auto colour = mesh.add_vertex_attribute<std::string>("grey");
  for (Vertex v : mesh.vertices()) EXPECT_EQ(colour[v], "grey");
  EXPECT_EQ(colour[mesh.add_vertex({5, 5, 5})], "grey");
  EXPECT_EQ(colour.slots().size(), mesh.vertex_slots());
}

TEST(Attribute, KeepsItsValuesWhenElementsAreAddedAndRemoved) {
  SurfaceMesh mesh = test::corner_tetrahedron();
  auto number = mesh.add_triangle_attribute<int>(-1);
  auto edge_number = mesh.add_edge_attribute<int>(-1);
  for (Triangle t : mesh.triangles()) number[t] = static_cast<int>(t.index());
  for (Edge e : mesh.edges()) edge_number[e] = static_cast<int>(e.index());
  const Vertex far = mesh.add_vertex({9, 9, 9});
  const Triangle added = mesh.add_triangle(Vertex(0), Vertex(1), far, {Region(2), air});
  mesh.remove_triangle(Triangle(1));
  for (Triangle t : mesh.triangles()) EXPECT_EQ(number[t], t == added ? -1 : static_cast<int>(t.index()));
  for (Edge e : mesh.edges()) EXPECT_EQ(edge_number[e], e.index() < 6 ? static_cast<int>(e.index()) : -1);
}

TEST(Attribute, AReusedSlotStartsWithTheInitialValueAgain) {
  SurfaceMesh mesh = test::corner_tetrahedron();
  auto weight = mesh.add_vertex_attribute<double>(0.5);
  const Vertex lone = mesh.add_vertex({1, 1, 1});
  weight[lone] = 7;
  mesh.remove_vertex(lone);
  const Vertex again = mesh.add_vertex({2, 2, 2});
  ASSERT_EQ(again, lone);
  EXPECT_EQ(weight[again], 0.5);
}

void expect_followed_through_compaction(SlotOrder order) {
  auto junction = test::triple_junction({120, 120, 120});
  SurfaceMesh& mesh = junction.mesh;
  auto place = mesh.add_vertex_attribute<Vec3>(Vec3::Zero());
  auto middle = mesh.add_edge_attribute<Vec3>(Vec3::Zero());
  auto centre = mesh.add_triangle_attribute<Vec3>(Vec3::Zero());
  auto middle_of = [&mesh](Edge e) {
    return Vec3(mesh.position(mesh.vertices(e)[0]) + mesh.position(mesh.vertices(e)[1]));
  };
  auto centre_of = [&mesh](Triangle t) {
    Vec3 sum = Vec3::Zero();
    for (Vertex v : mesh.vertices(t)) sum += mesh.position(v);
    return sum;
  };
  for (Vertex v : mesh.vertices()) place[v] = mesh.position(v);
  for (Edge e : mesh.edges()) middle[e] = middle_of(e);
  for (Triangle t : mesh.triangles()) centre[t] = centre_of(t);
  for (std::size_t i = 0; i < mesh.triangle_slots(); i += 3) mesh.remove_triangle(Triangle(i));
  for (std::size_t i = 0; i < mesh.vertex_slots(); ++i)
    if (mesh.triangles(Vertex(i)).empty()) mesh.remove_vertex(Vertex(i));
  const std::size_t vertices = mesh.vertex_count(), edges = mesh.edge_count(), triangles = mesh.triangle_count();
  ASSERT_LT(edges, mesh.edge_slots());
  mesh.compact(order);
  EXPECT_EQ(mesh.vertex_slots(), vertices);
  EXPECT_EQ(mesh.edge_slots(), edges);
  EXPECT_EQ(mesh.triangle_slots(), triangles);
  EXPECT_EQ(place.slots().size(), vertices);
  for (Vertex v : mesh.vertices()) EXPECT_EQ(place[v], mesh.position(v));
  for (Edge e : mesh.edges()) EXPECT_EQ(middle[e], middle_of(e));
  for (Triangle t : mesh.triangles()) EXPECT_EQ(centre[t], centre_of(t));
  EXPECT_FALSE(audit(mesh, {.intersections = false, .closed_regions = false}).has(Defect::broken_incidence));
}

TEST(Attribute, FollowsItsElementsThroughCompaction) {
  for (SlotOrder order : {SlotOrder::as_before, SlotOrder::by_place}) expect_followed_through_compaction(order);
}

TEST(Attribute, MovesWithItsMesh) {
  SurfaceMesh mesh = test::corner_tetrahedron();
  auto number = mesh.add_vertex_attribute<int>(3);
  SurfaceMesh moved = std::move(mesh);
  const Vertex v = moved.add_vertex({1, 1, 1});
  EXPECT_EQ(number[v], 3);
  EXPECT_EQ(number.slots().size(), moved.vertex_slots());
}

TEST(Attribute, StaysBehindWhenAMeshIsCloned) {
  SurfaceMesh mesh = test::corner_tetrahedron();
  auto number = mesh.add_vertex_attribute<int>(3);
  SurfaceMesh copy = mesh.clone();
  copy.add_vertex({1, 1, 1});
  EXPECT_EQ(number.slots().size(), mesh.vertex_slots());
}

TEST(Attribute, EitherMayBeDestroyedFirst) {
  std::optional<VertexAttribute<int>> attribute;
  {
    SurfaceMesh mesh = test::corner_tetrahedron();
    attribute = mesh.add_vertex_attribute<int>(4);
    (*attribute)[Vertex(2)] = 5;
  }
  EXPECT_EQ((*attribute)[Vertex(2)], 5);
  SurfaceMesh mesh = test::corner_tetrahedron();
  { const auto gone = mesh.add_vertex_attribute<int>(1); }
  mesh.add_vertex({1, 1, 1});
  mesh.compact();
  EXPECT_EQ(mesh.vertex_count(), 5U);
}

TEST(Attribute, CountsInTheMemoryOfTheMesh) {
  SurfaceMesh mesh = test::corner_tetrahedron();
  const std::size_t before = mesh.memory_bytes();
  const auto big = mesh.add_vertex_attribute<std::array<double, 100>>({});
  EXPECT_GE(mesh.memory_bytes(), before + 4 * 100 * sizeof(double));
}

}  // namespace
}  // namespace lostopos
