// Every reason for a refusal, each by a mesh made for it; the mesh is the same to the bit afterwards.
#include <gtest/gtest.h>

#include "LosTopos/mesh/audit.h"
#include "LosTopos/remeshing/edge_collapse.h"
#include "LosTopos/remeshing/edge_flip.h"
#include "LosTopos/remeshing/edge_split.h"
#include "LosTopos/remeshing/null_space_smoothing.h"
#include "tests/LosTopos/remeshing/patches.h"
#include "tests/support/film_meshes.h"
#include "tests/support/sample_meshes.h"

namespace lostopos {
namespace {

using test::wide_bounds;

struct MustStaySilent final : OperationObserver {
  void before_split(const SurfaceMesh&, const SplitEvent&) override { ADD_FAILURE(); }
  void before_collapse(const SurfaceMesh&, const CollapseEvent&) override { ADD_FAILURE(); }
  void before_flip(const SurfaceMesh&, const FlipEvent&) override { ADD_FAILURE(); }
  void before_move(const SurfaceMesh&, const MoveEvent&) override { ADD_FAILURE(); }
};

class Refused : public ::testing::Test {
 protected:
  template <class Operation, class Element>
  void expect(Refusal reason, SurfaceMesh& mesh, Element element, const RemeshOptions& options = wide_bounds(),
              std::initializer_list<Vertex> held_vertices = {}) {
    auto held = mesh.add_vertex_attribute<Hold>(Hold::none);
    auto mark = mesh.add_vertex_attribute<int>(3);
    for (Vertex v : held_vertices) held[v] = Hold::all;
    MustStaySilent observer;
    const std::array<OperationObserver*, 1> observers = {&observer};
    const auto before = mesh.state();
    RemeshContext context(mesh, held, options, observers);
    Operation operation(context);
    for (const auto refusal : {operation.check(element), operation.attempt(element)}) {
      ASSERT_TRUE(refusal.has_value());
      EXPECT_STREQ(name(*refusal), name(reason));
    }
    EXPECT_TRUE(test::same_bits(before, mesh.state()));
    for (int m : mark.slots()) EXPECT_EQ(m, 3);
  }
};

SurfaceMesh rhombus() {
  return test::two_triangles({-0.5, 0, 0}, {0.5, 0, 0}, {0, 0.866, 0}, {0, -0.866, 0});
}

// The long diagonal of a flat quadrilateral.
SurfaceMesh flat_kite() {
  return test::two_triangles({-1, 0, 0}, {1, 0, 0}, {0, 0.4, 0}, {0, -0.4, 0});
}

TEST_F(Refused, HeldEdges) {
  SurfaceMesh mesh = flat_kite();
  const Edge e = mesh.find_edge(Vertex(0), Vertex(1));
  expect<EdgeSplit>(Refusal::held, mesh, e, wide_bounds(), {Vertex(0), Vertex(1)});
  expect<EdgeCollapse>(Refusal::held, mesh, e, wide_bounds(), {Vertex(0), Vertex(1)});
  expect<EdgeFlip>(Refusal::held, mesh, e, wide_bounds(), {Vertex(0), Vertex(1)});
  expect<NullSpaceSmoothing>(Refusal::held, mesh, Vertex(2), wide_bounds(), {Vertex(2)});
}

TEST_F(Refused, HeldFilmVertexDoesNotPullABorderToItself) {
  SurfaceMesh mesh = test::tent(0.3);
  expect<EdgeCollapse>(Refusal::held, mesh, mesh.find_edge(Vertex(0), Vertex(1)), wide_bounds(), {Vertex(0)});
}

TEST_F(Refused, FlipOfAJunctionEdge) {
  SurfaceMesh mesh = test::analytic_double_bubble(1, 12);
  const Edge e = test::first_edge(mesh, [&](Edge f) { return mesh.is_junction(f); });
  expect<EdgeFlip>(Refusal::junction_topology, mesh, e);
}

TEST_F(Refused, CollapseBetweenTwoPlateauVertices) {
  auto cube = test::cube_frame(1);
  expect<EdgeCollapse>(Refusal::junction_topology, cube.mesh, cube.mesh.find_edge(Vertex(0), Vertex(1)));
}

TEST_F(Refused, SmoothingOfAPlateauVertex) {
  auto cube = test::cube_frame(3);
  expect<NullSpaceSmoothing>(Refusal::junction_topology, cube.mesh, Vertex(0));
}

TEST_F(Refused, CollapseOfAFilmEdgeAcrossAStrip) {
  // Both ends are on the film's free border, on different sides.
  SurfaceMesh mesh = test::two_triangles({0, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0, 0});
  expect<EdgeCollapse>(Refusal::junction_topology, mesh, mesh.find_edge(Vertex(0), Vertex(1)));
}

TEST_F(Refused, CollapseThatWouldCloseABorderOfThreeEdges) {
  SurfaceMesh mesh;
  for (const Vec3& x : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0.5, 1, 0)}) mesh.add_vertex(x);
  mesh.add_triangle(Vertex(0), Vertex(1), Vertex(2), test::film);
  expect<EdgeCollapse>(Refusal::junction_topology, mesh, mesh.find_edge(Vertex(0), Vertex(1)));
}

TEST_F(Refused, TetrahedronCannotGetSmaller) {
  SurfaceMesh mesh = test::corner_tetrahedron();
  expect<EdgeCollapse>(Refusal::link_condition, mesh, mesh.find_edge(Vertex(1), Vertex(2)));
  expect<EdgeFlip>(Refusal::link_condition, mesh, mesh.find_edge(Vertex(1), Vertex(2)));
}

TEST_F(Refused, FlipBetweenDifferentFilms) {
  SurfaceMesh mesh = flat_kite();
  mesh.set_labels(Triangle(1), {Region(2), air});
  expect<EdgeFlip>(Refusal::labels, mesh, mesh.find_edge(Vertex(0), Vertex(1)));
}

TEST_F(Refused, SmallAngle) {
  SurfaceMesh mesh = rhombus();  // a split makes angles of 30 degrees
  RemeshOptions options = wide_bounds();
  options.min_angle = 40;
  expect<EdgeSplit>(Refusal::small_angle, mesh, mesh.find_edge(Vertex(0), Vertex(1)), options);
}

TEST_F(Refused, LargeAngle) {
  SurfaceMesh mesh = rhombus();  // and of 90 degrees
  RemeshOptions options = wide_bounds();
  options.max_angle = 85;
  expect<EdgeSplit>(Refusal::large_angle, mesh, mesh.find_edge(Vertex(0), Vertex(1)), options);
}

TEST_F(Refused, SmallArea) {
  SurfaceMesh mesh = rhombus();
  RemeshOptions options = wide_bounds();
  options.min_area = 0.3;
  expect<EdgeSplit>(Refusal::small_area, mesh, mesh.find_edge(Vertex(0), Vertex(1)), options);
}

TEST_F(Refused, LongEdge) {
  SurfaceMesh mesh = test::hexagonal_patch(2);  // a collapse to the midpoint makes edges of length 1.32
  RemeshOptions options = wide_bounds();
  options.longest_edge = 1.2;
  const Edge e = mesh.edges(Vertex(0))[0];
  expect<EdgeCollapse>(Refusal::long_edge, mesh, e, options);
}

TEST_F(Refused, InvertedNormalInAQuadrilateralThatIsNotConvex) {
  SurfaceMesh mesh = test::two_triangles({0, 0, 0}, {1, 0, 0}, {-0.5, 0.4, 0}, {-0.5, -0.4, 0});
  expect<EdgeFlip>(Refusal::inverted_normal, mesh, mesh.find_edge(Vertex(0), Vertex(1)));
}

TEST_F(Refused, VolumeChange) {
  SurfaceMesh mesh = test::globe(1, 8);
  RemeshOptions options = wide_bounds();
  options.max_volume_change = 1e-6;
  // To a held end there is no shift that keeps the volume.
  expect<EdgeCollapse>(Refusal::volume_change, mesh, mesh.edges(Vertex(20))[0], options, {Vertex(20)});
}

TEST_F(Refused, FlipOverAPebbleUnderARoof) {
  SurfaceMesh mesh = test::two_triangles({-1, 0, 0}, {1, 0, 0}, {0, 0.5, -0.2}, {0, -0.5, -0.2});
  const Edge ridge = mesh.find_edge(Vertex(0), Vertex(1));
  test::add_pebble(mesh, {0, 0, -0.1}, 0.02, Region(1));
  expect<EdgeFlip>(Refusal::intersection, mesh, ridge);
}

TEST_F(Refused, FlipThroughAnEdgeThatCrossesTheTetrahedron) {
  // Both ends of the needle are outside of the tetrahedron between roof and floor; it crosses two of its faces.
  SurfaceMesh mesh = test::two_triangles({-1, 0, 0}, {1, 0, 0}, {0, 0.5, -0.2}, {0, -0.5, -0.2});
  const Edge ridge = mesh.find_edge(Vertex(0), Vertex(1));
  const Vertex a = mesh.add_vertex({-0.02, 0.03, -0.5}), b = mesh.add_vertex({0.02, 0.03, -0.5}),
               tip = mesh.add_vertex({0, 0, -0.1});
  mesh.add_triangle(a, b, tip, {Region(5), Region(1)});
  expect<EdgeFlip>(Refusal::intersection, mesh, ridge);
}

TEST_F(Refused, CollapseThatWouldSweepOverAPebble) {
  SurfaceMesh mesh = test::tent(0.5);
  test::add_pebble(mesh, {0, 0, 0.1}, 0.02, Region(1));
  expect<EdgeCollapse>(Refusal::intersection, mesh, mesh.find_edge(Vertex(0), Vertex(1)));
}

TEST_F(Refused, SplitOnAnotherSurface) {
  // The plane of another triangle cuts between the smooth position and the midpoint, and one touches the midpoint.
  SurfaceMesh mesh = rhombus();
  const Vertex touching = mesh.add_vertex({0, 0, 0}), b = mesh.add_vertex({0.1, 0, 1}),
               c = mesh.add_vertex({0, 0.1, 1});
  mesh.add_triangle(touching, b, c, {Region(5), air});
  expect<EdgeSplit>(Refusal::intersection, mesh, mesh.find_edge(Vertex(0), Vertex(1)));
}

// A patch bent to a valley, with the vertex in its middle off to one side.
SurfaceMesh valley() {
  SurfaceMesh mesh = test::hexagonal_patch(1);
  mesh.set_position(Vertex(0), {0.6, 0, 0});
  for (Vertex v : mesh.vertices()) {
    const double x = mesh.position(v)[0];
    mesh.set_position(v, mesh.position(v) + Vec3(0, 0, 0.3 * x * x));
  }
  return mesh;
}

TEST_F(Refused, SmoothingThatWouldHitAPebble) {
  SurfaceMesh free = valley(), hindered = valley();
  auto held = free.add_vertex_attribute<Hold>(Hold::none);
  const RemeshOptions options = wide_bounds();
  RemeshContext context(free, held, options);
  ASSERT_FALSE(NullSpaceSmoothing(context).attempt(Vertex(0)).has_value());
  // On the way, at a quarter and so before the end of a half step too.
  test::add_pebble(hindered, 0.75 * hindered.position(Vertex(0)) + 0.25 * free.position(Vertex(0)), 1e-3, air);
  ASSERT_EQ(audit(hindered, {.closed_regions = false}).text(), "clean");
  expect<NullSpaceSmoothing>(Refusal::intersection, hindered, Vertex(0));
}

TEST_F(Refused, NotBetter) {
  SurfaceMesh mesh = test::hexagonal_patch(2);
  expect<EdgeFlip>(Refusal::not_better, mesh, mesh.edges(Vertex(0))[0]);
  expect<NullSpaceSmoothing>(Refusal::not_better, mesh, Vertex(0));
}

}  // namespace
}  // namespace lostopos
