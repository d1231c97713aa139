#include "LosTopos/mesh/surface_mesh.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "LosTopos/error.h"
#include "LosTopos/mesh/audit.h"
#include "tests/support/sample_meshes.h"

namespace lostopos {
namespace {

constexpr Labels kFilm{Region(1), air};

template <class Range>
auto as_set(const Range& range) {
  using Element = std::remove_cvref_t<decltype(*range.begin())>;
  return std::set<Element>(range.begin(), range.end());
}

TEST(SurfaceMesh, ATetrahedronHasTheCountsAndIncidenceOfOne) {
  const SurfaceMesh mesh = test::corner_tetrahedron();
  EXPECT_EQ(mesh.vertex_count(), 4U);
  EXPECT_EQ(mesh.edge_count(), 6U);
  EXPECT_EQ(mesh.triangle_count(), 4U);
  for (Vertex v : mesh.vertices()) {
    EXPECT_EQ(mesh.edges(v).size(), 3U);
    EXPECT_EQ(mesh.triangles(v).size(), 3U);
    EXPECT_FALSE(mesh.is_junction(v));
  }
  for (Edge e : mesh.edges()) EXPECT_EQ(mesh.triangles(e).size(), 2U);
  for (Triangle t : mesh.triangles())
    for (int i = 0; i < 3; ++i) {
      const Edge e = mesh.edges(t)[i];
      EXPECT_EQ(mesh.opposite_vertex(t, e), mesh.vertices(t)[i]);
      EXPECT_EQ(e, mesh.find_edge(mesh.vertices(t)[(i + 1) % 3], mesh.vertices(t)[(i + 2) % 3]));
      const auto [a, b] = mesh.vertices(e);
      EXPECT_EQ(mesh.other_vertex(e, a), b);
      EXPECT_EQ(mesh.other_vertex(e, b), a);
    }
}

TEST(SurfaceMesh, NeighboursThatAreOrientedAlikeRunAlongTheirEdgeInOppositeDirections) {
  const SurfaceMesh mesh = test::corner_tetrahedron();
  for (Edge e : mesh.edges())
    EXPECT_NE(mesh.runs_along(mesh.triangles(e)[0], e), mesh.runs_along(mesh.triangles(e)[1], e));
}

TEST(SurfaceMesh, ThreeTrianglesAtAnEdgeMakeAJunction) {
  const auto junction = test::triple_junction({120, 120, 120});
  const SurfaceMesh& mesh = junction.mesh;
  const auto border = as_set(junction.border);
  for (Vertex v : mesh.vertices()) EXPECT_EQ(mesh.is_junction(v), border.count(v) == 1);
  std::size_t junction_edges = 0;
  for (Edge e : mesh.edges())
    if (mesh.is_junction(e)) ++junction_edges;
  EXPECT_EQ(junction_edges, border.size() - 1);
}

TEST(SurfaceMesh, RemovingATriangleRemovesTheEdgesThatNoneUsesAndKeepsVertices) {
  SurfaceMesh mesh = test::corner_tetrahedron();
  const Triangle first(0), second(1);
  mesh.remove_triangle(first);
  EXPECT_EQ(mesh.triangle_count(), 3U);
  EXPECT_EQ(mesh.edge_count(), 6U) << "each edge is still used by the other triangle";
  EXPECT_FALSE(mesh.alive(first));
  mesh.remove_triangle(second);
  EXPECT_EQ(mesh.edge_count(), 5U) << "the edge of both is gone";
  EXPECT_EQ(mesh.vertex_count(), 4U);
  EXPECT_FALSE(audit(mesh).has(Defect::broken_incidence)) << audit(mesh).text();
}

TEST(SurfaceMesh, SlotsOfRemovedElementsAreUsedAgain) {
  SurfaceMesh mesh = test::corner_tetrahedron();
  const auto corners = mesh.vertices(Triangle(2));
  mesh.remove_triangle(Triangle(2));
  const std::size_t slots = mesh.triangle_slots();
  EXPECT_EQ(mesh.add_triangle(corners[0], corners[1], corners[2], kFilm), Triangle(2));
  EXPECT_EQ(mesh.triangle_slots(), slots);
  const Vertex lone = mesh.add_vertex({1, 2, 3});
  mesh.remove_vertex(lone);
  EXPECT_FALSE(mesh.alive(lone));
  EXPECT_EQ(mesh.add_vertex({3, 2, 1}), lone);
  EXPECT_EQ(mesh.position(lone), Vec3(3, 2, 1));
}

TEST(SurfaceMesh, RangesVisitTheLivingOnlyInSlotOrder) {
  SurfaceMesh mesh = test::corner_tetrahedron();
  mesh.remove_triangle(Triangle(0));
  mesh.remove_triangle(Triangle(2));
  std::vector<Triangle> seen;
  for (Triangle t : mesh.triangles()) seen.push_back(t);
  EXPECT_EQ(seen, (std::vector<Triangle>{Triangle(1), Triangle(3)}));
}

TEST(SurfaceMesh, IncidenceKeepsTheOrderOfInsertion) {
  SurfaceMesh mesh;
  const Vertex centre = mesh.add_vertex({0, 0, 0});
  std::vector<Vertex> ring;
  ring.reserve(6);
  for (int i = 0; i < 6; ++i) ring.push_back(mesh.add_vertex({std::cos(i), std::sin(i), 0}));
  std::vector<Triangle> fan;
  for (std::size_t i = 0; i + 1 < ring.size(); ++i)
    fan.push_back(mesh.add_triangle(centre, ring[i], ring[i + 1], kFilm));
  mesh.remove_triangle(fan[2]);
  fan.erase(fan.begin() + 2);
  const auto at_centre = mesh.triangles(centre);
  EXPECT_EQ(std::vector<Triangle>(at_centre.begin(), at_centre.end()), fan);
}

template <class Action>
std::string message_of(Action&& action) {
  try {
    action();
  } catch (const MeshError& error) {
    return error.what();
  }
  return "no MeshError";
}

TEST(SurfaceMeshErrors, SayWhatWasAskedOfWhichElement) {
  SurfaceMesh mesh = test::corner_tetrahedron();
  const Vertex a(0), b(1), c(2), nowhere(17);
  EXPECT_NE(message_of([&] { mesh.add_triangle(a, b, nowhere, kFilm); }).find("vertex 17"), std::string::npos);
  EXPECT_NE(message_of([&] { mesh.add_triangle(a, b, a, kFilm); }).find("vertex 0"), std::string::npos);
  EXPECT_NE(message_of([&] { mesh.add_triangle(a, c, c, kFilm); }).find("vertex 2"), std::string::npos);
  EXPECT_NE(message_of([&] { mesh.add_triangle(a, b, c, {air, air}); }).find("(0, 0)"), std::string::npos);
  EXPECT_NE(message_of([&] { mesh.add_triangle(a, b, c, {air, Region()}); }).find("labels"), std::string::npos);
  EXPECT_NE(message_of([&] { mesh.set_labels(Triangle(0), {air, air}); }).find("(0, 0)"), std::string::npos);
  EXPECT_NE(message_of([&] { mesh.remove_vertex(a); }).find("3 triangles"), std::string::npos);
  EXPECT_NE(message_of([&] { mesh.remove_triangle(Triangle(4)); }).find("triangle 4"), std::string::npos);
  EXPECT_NE(message_of([&] { mesh.remove_vertex(nowhere); }).find("vertex 17"), std::string::npos);
}

TEST(SurfaceMeshErrors, LeaveTheMeshAsItWas) {
  SurfaceMesh mesh = test::corner_tetrahedron();
  EXPECT_THROW(mesh.add_triangle(Vertex(0), Vertex(1), Vertex(9), kFilm), MeshError);
  EXPECT_THROW(mesh.add_triangle(Vertex(0), Vertex(1), Vertex(1), kFilm), MeshError);
  EXPECT_THROW(mesh.add_triangle(Vertex(0), Vertex(1), Vertex(2), {air, air}), MeshError);
  EXPECT_EQ(mesh.triangle_slots(), 4U);
  EXPECT_EQ(mesh.edge_slots(), 6U);
  EXPECT_TRUE(audit(mesh).clean()) << audit(mesh).text();
}

}  // namespace
}  // namespace lostopos
