#include "LosTopos/mesh/audit.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "LosTopos/geometry/predicates.h"
#include "LosTopos/mesh/audit_intersections.h"
#include "tests/support/sample_meshes.h"

namespace lostopos {
namespace {

constexpr Labels outer_film{Region(1), air};

void expect_only(const SurfaceMesh& mesh, Defect defect, const AuditOptions& options = {}) {
  const AuditReport report = audit(mesh, options);
  EXPECT_TRUE(report.has(defect)) << report.text();
  for (const Finding& finding : report.findings) EXPECT_EQ(finding.defect, defect) << report.text();
}

template <class Change>
SurfaceMesh tampered(Change&& change) {
  auto state = test::corner_tetrahedron().state();
  change(state);
  SurfaceMesh mesh;
  mesh.restore(state);
  return mesh;
}

TEST(AuditClean, ClosedBubbles) {
  EXPECT_EQ(audit(test::corner_tetrahedron()).text(), "clean");
  EXPECT_EQ(audit(test::globe(1, 12)).text(), "clean");
}

TEST(AuditClean, BubbleWithinABubbleAndBubblesSideBySide) {
  SurfaceMesh mesh = test::globe(1, 12);
  test::add_corner_tetrahedron(mesh, 0.3, {0, 0, 0}, Region(2), Region(1));
  test::add_corner_tetrahedron(mesh, 1, {1.1, 0, 0}, Region(3), air);
  EXPECT_EQ(audit(mesh).text(), "clean");
}

TEST(AuditClean, OpenFilmsWhenTheyAreAllowed) {
  const AuditOptions open{.closed_regions = false};
  EXPECT_EQ(audit(test::open_cylinder(1, 8, 3, 0.5), open).text(), "clean");
  EXPECT_EQ(audit(test::triple_junction({120, 120, 120}).mesh, open).text(), "clean");
  EXPECT_EQ(audit(test::triple_junction({20, 300, 40}).mesh, open).text(), "clean");
}

TEST(AuditClean, EmptyMesh) {
  EXPECT_TRUE(audit(SurfaceMesh()).clean());
}

TEST(AuditBrokenIncidence, VertexForgetsItsTriangle) {
  expect_only(tampered([](auto& s) { s.vertex_triangles[2].pop_back(); }), Defect::broken_incidence);
}

TEST(AuditBrokenIncidence, VertexListsATriangleThatIsNotThere) {
  expect_only(tampered([](auto& s) { s.vertex_triangles[0].push_back(Triangle(3)); }), Defect::broken_incidence);
}

TEST(AuditBrokenIncidence, VertexListsATriangleTwice) {
  expect_only(tampered([](auto& s) { s.vertex_triangles[0].push_back(s.vertex_triangles[0][0]); }),
              Defect::broken_incidence);
}

TEST(AuditBrokenIncidence, IsFoundBehindManyIsolatedVertices) {
  auto state = tampered([](auto& s) { s.vertex_triangles[2].pop_back(); }).state();
  SurfaceMesh mesh;
  mesh.restore(state);
  for (int i = 0; i < 10; ++i) (void)mesh.add_vertex({5.0 + i, 0, 0});
  EXPECT_TRUE(audit(mesh, {.max_findings = 3}).has(Defect::broken_incidence));
}

TEST(AuditBrokenIncidence, VertexForgetsItsEdge) {
  expect_only(tampered([](auto& s) { s.vertex_edges[1].pop_back(); }), Defect::broken_incidence);
}

TEST(AuditBrokenIncidence, EdgeListsAStrangersTriangle) {
  expect_only(tampered([](auto& s) {
                for (std::size_t t = 0; t < 4; ++t)
                  if (std::ranges::count(s.triangle_edges[t], Edge(0)) == 0) s.edge_triangles[0].push_back(Triangle(t));
              }),
              Defect::broken_incidence);
}

TEST(AuditBrokenIncidence, EdgeForgetsItsTriangle) {
  expect_only(tampered([](auto& s) { s.edge_triangles[4].pop_back(); }), Defect::broken_incidence);
}

TEST(AuditBrokenIncidence, EdgeEndsTwiceAtTheSameVertex) {
  expect_only(tampered([](auto& s) { s.edge_vertices[3][1] = s.edge_vertices[3][0]; }), Defect::broken_incidence);
}

TEST(AuditBrokenIncidence, TriangleHasTheWrongEdgeOppositeToACorner) {
  expect_only(tampered([](auto& s) { std::swap(s.triangle_edges[1][0], s.triangle_edges[1][2]); }),
              Defect::broken_incidence);
}

TEST(AuditBadLabels, SameRegionOnBothSides) {
  EXPECT_TRUE(audit(tampered([](auto& s) { s.labels[0] = {air, air}; })).has(Defect::bad_labels));
}

TEST(AuditBadLabels, NoRegionOnOneSide) {
  EXPECT_TRUE(audit(tampered([](auto& s) { s.labels[0] = {Region(1), Region()}; })).has(Defect::bad_labels));
}

TEST(AuditDuplicateTriangle, OnTopOfAnotherAndTurnedRound) {
  for (const auto& order : {std::array{0, 1, 2}, std::array{2, 1, 0}}) {
    SurfaceMesh mesh = test::corner_tetrahedron();
    const auto v = mesh.vertices(Triangle(3));
    mesh.add_triangle(v[static_cast<std::size_t>(order[0])], v[static_cast<std::size_t>(order[1])],
                      v[static_cast<std::size_t>(order[2])], {Region(2), air});
    EXPECT_TRUE(audit(mesh).has(Defect::duplicate_triangle));
  }
}

TEST(AuditIsolatedVertex, WithoutATriangle) {
  SurfaceMesh mesh = test::corner_tetrahedron();
  mesh.add_vertex({5, 5, 5});
  expect_only(mesh, Defect::isolated_vertex);
}

TEST(AuditNotFinite, NaNAndInfinity) {
  for (double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    SurfaceMesh mesh = test::corner_tetrahedron();
    mesh.set_position(Vertex(2), {0, bad, 0});
    expect_only(mesh, Defect::not_finite);
  }
}

TEST(AuditDegenerateTriangle, CornersOnALine) {
  SurfaceMesh mesh;
  const Vertex a = mesh.add_vertex({0, 0, 0}), b = mesh.add_vertex({1, 1, 1}), c = mesh.add_vertex({3, 3, 3});
  mesh.add_triangle(a, b, c, outer_film);
  expect_only(mesh, Defect::degenerate_triangle, {.closed_regions = false});
}

TEST(AuditDegenerateTriangle, AlmostOnALineIsNone) {
  SurfaceMesh mesh;
  const Vertex a = mesh.add_vertex({0, 0, 0}), b = mesh.add_vertex({1, 1, 1}),
               c = mesh.add_vertex({3, 3, std::nextafter(3.0, 4.0)});
  mesh.add_triangle(a, b, c, outer_film);
  EXPECT_TRUE(audit(mesh, {.closed_regions = false}).clean());
}

TEST(AuditOpenRegion, BubbleWithAHole) {
  SurfaceMesh mesh = test::globe(1, 8);
  mesh.remove_triangle(Triangle(20));
  expect_only(mesh, Defect::open_region);
  EXPECT_EQ(audit(mesh).findings.size(), 3U) << "one an edge of the hole";
}

TEST(AuditInconsistentLabels, OneTriangleTurnedInsideOut) {
  SurfaceMesh mesh = test::globe(1, 8);
  mesh.set_labels(Triangle(20), mesh.labels(Triangle(20)).flipped());
  expect_only(mesh, Defect::inconsistent_labels);
}

TEST(AuditInconsistentLabels, AFilmOfTheWrongBubble) {
  SurfaceMesh mesh = test::globe(1, 8);
  mesh.set_labels(Triangle(20), {Region(2), air});
  expect_only(mesh, Defect::inconsistent_labels);
}

TEST(AuditInconsistentLabels, TwoFilmsSwappedAtAPlateauBorder) {
  auto junction = test::triple_junction({120, 120, 120});
  SurfaceMesh& mesh = junction.mesh;
  for (Triangle t : mesh.triangles()) mesh.set_labels(t, mesh.labels(t).flipped());
  expect_only(mesh, Defect::inconsistent_labels, {.closed_regions = false});
}

TEST(AuditIntersection, TwoBubblesThroughEachOther) {
  SurfaceMesh mesh = test::corner_tetrahedron(1);
  test::add_corner_tetrahedron(mesh, 1, {0.2, 0.2, -0.3}, Region(2), air);
  expect_only(mesh, Defect::intersection);
}

TEST(AuditIntersection, ABubblesCornerTouchesAnothersFace) {
  SurfaceMesh mesh = test::corner_tetrahedron(1);
  // Its top corner (0.25, 0.25, 0) lies in the other's bottom face.
  test::add_corner_tetrahedron(mesh, 0.125, {0.25, 0.25, -0.125}, Region(2), air);
  expect_only(mesh, Defect::intersection);
}

TEST(AuditIntersection, OneUlpApartIsNone) {
  SurfaceMesh mesh = test::corner_tetrahedron(1);
  test::add_corner_tetrahedron(mesh, 0.125, {0.25, 0.25, std::nextafter(-0.125, -1.0)}, Region(2), air);
  EXPECT_EQ(audit(mesh).text(), "clean");
}

TEST(AuditIntersection, AVertexPushedThroughTheFarSideOfItsBubble) {
  SurfaceMesh mesh = test::globe(1, 8);
  mesh.set_position(Vertex(0), {1.5, 0.01, 0.02});
  EXPECT_TRUE(audit(mesh).has(Defect::intersection));
}

TEST(AuditIntersection, TwoTrianglesFoldedOntoEachOther) {
  SurfaceMesh mesh;
  const Vertex a = mesh.add_vertex({0, 0, 0}), b = mesh.add_vertex({1, 0, 0}), c = mesh.add_vertex({0.2, 1, 0}),
               d = mesh.add_vertex({0.6, 0.5, 0});
  mesh.add_triangle(a, b, c, outer_film);
  mesh.add_triangle(b, a, d, outer_film);
  EXPECT_TRUE(audit(mesh, {.closed_regions = false}).has(Defect::intersection));
}

TEST(AuditIntersection, CanBeLeftOut) {
  SurfaceMesh mesh = test::corner_tetrahedron(1);
  test::add_corner_tetrahedron(mesh, 1, {0.2, 0.2, -0.3}, Region(2), air);
  EXPECT_TRUE(audit(mesh, {.intersections = false}).clean());
}

TEST(AuditReportTest, NamesElementsAndStopsAtTheLimit) {
  SurfaceMesh mesh = test::corner_tetrahedron();
  for (int i = 0; i < 8; ++i) mesh.add_vertex({5.25, 5, 5});
  const AuditReport report = audit(mesh, {.max_findings = 3});
  EXPECT_EQ(report.findings.size(), 3U);
  EXPECT_TRUE(report.truncated);
  EXPECT_NE(report.text().find("vertex 4 at (5.25"), std::string::npos) << report.text();
  EXPECT_NE(report.text().find("left out"), std::string::npos);
}

class CrumpledSphere : public testing::TestWithParam<Vec3> {};

TEST_P(CrumpledSphere, CrossesItselfWhereAllPairsSay) {
  SurfaceMesh mesh = test::globe(1, 10);
  // Deterministic crumpling strong enough to make some parts cross.
  for (Vertex v : mesh.vertices()) {
    const auto i = static_cast<double>(v.index());
    mesh.set_position(v, mesh.position(v) + 0.35 * Vec3(std::sin(7 * i), std::sin(11 * i), std::sin(13 * i)));
    mesh.set_position(v, mesh.position(v).cwiseProduct(GetParam()));
  }
  std::size_t crossings = 0;
  for (Triangle t : mesh.triangles())
    for (Edge e : mesh.edges()) {
      const auto& v = mesh.vertices(t);
      const auto& ends = mesh.vertices(e);
      if (std::ranges::count(v, ends[0]) + std::ranges::count(v, ends[1]) > 0) continue;
      if (segment_triangle_intersect(mesh.position(ends[0]), mesh.position(ends[1]), mesh.position(v[0]),
                                     mesh.position(v[1]), mesh.position(v[2])) != Crossing::none)
        ++crossings;
    }
  ASSERT_GT(crossings, 10U);
  EXPECT_EQ(edge_triangle_contacts(mesh, 100000).size(), crossings);
  EXPECT_EQ(edge_triangle_contacts(mesh, 5).size(), 5U);
}

INSTANTIATE_TEST_SUITE_P(Shapes, CrumpledSphere,
                         testing::Values(Vec3(1, 1, 1), Vec3(100, 1, 1), Vec3(1, 30, 0.1), Vec3(1, 30, 100),
                                         Vec3(1e-200, 1e-200, 1e-200)));

}  // namespace
}  // namespace lostopos
