// What each operation leaves behind, and what it tells its observers.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <string>

#include "LosTopos/mesh/audit.h"
#include "LosTopos/mesh/measures.h"
#include "LosTopos/remeshing/edge_collapse.h"
#include "LosTopos/remeshing/edge_flip.h"
#include "LosTopos/remeshing/edge_split.h"
#include "LosTopos/remeshing/null_space_smoothing.h"
#include "tests/LosTopos/remeshing/patches.h"
#include "tests/support/film_meshes.h"
#include "tests/support/sample_meshes.h"

namespace lostopos {
namespace {

using test::volume;

double linear(const Vec3& x) {
  return 1 + 2 * x[0] - 3 * x[1] + 0.5 * x[2];
}

/// Carries a value a vertex and a number a triangle, and checks what it is told.
class Carrier final : public OperationObserver {
 public:
  explicit Carrier(SurfaceMesh& mesh)
      : value(mesh.add_vertex_attribute<double>(0)), number(mesh.add_triangle_attribute<int>(-1)) {
    for (Vertex v : mesh.vertices()) value[v] = linear(mesh.position(v));
    for (Triangle t : mesh.triangles()) number[t] = static_cast<int>(t.index());
  }

  void before_split(const SurfaceMesh& mesh, const SplitEvent& e) override {
    told += "split(";
    EXPECT_EQ(mesh.vertices(e.edge), e.ends);
    EXPECT_FALSE(e.added.valid());
  }
  void after_split(const SurfaceMesh& mesh, const SplitEvent& e) override {
    told += ")";
    EXPECT_FALSE(mesh.alive(e.edge));
    EXPECT_EQ(mesh.position(e.added), e.position);
    value[e.added] = 0.5 * (value[e.ends[0]] + value[e.ends[1]]);
    inherit(mesh, e.triangles);
  }
  void before_collapse(const SurfaceMesh& mesh, const CollapseEvent& e) override {
    told += "collapse(";
    EXPECT_TRUE(mesh.alive(e.kept) && mesh.alive(e.removed));
    merged_ = (1 - e.t) * value[e.kept] + e.t * value[e.removed];
  }
  void after_collapse(const SurfaceMesh& mesh, const CollapseEvent& e) override {
    told += ")";
    EXPECT_FALSE(mesh.alive(e.removed));
    EXPECT_EQ(mesh.position(e.kept), e.position);
    value[e.kept] = merged_;
    inherit(mesh, e.triangles);
  }
  void before_flip(const SurfaceMesh& mesh, const FlipEvent& e) override {
    told += "flip(";
    EXPECT_EQ(mesh.vertices(e.edge), e.old_ends);
  }
  void after_flip(const SurfaceMesh& mesh, const FlipEvent& e) override {
    told += ")";
    EXPECT_EQ(mesh.find_edge(e.new_ends[0], e.new_ends[1]), e.added);
    EXPECT_FALSE(mesh.find_edge(e.old_ends[0], e.old_ends[1]).valid());
    inherit(mesh, e.triangles);
  }
  void before_move(const SurfaceMesh& mesh, const MoveEvent& e) override {
    told += "move(";
    EXPECT_EQ(mesh.position(e.vertex), e.from);
  }
  void after_move(const SurfaceMesh& mesh, const MoveEvent& e) override {
    told += ")";
    EXPECT_EQ(mesh.position(e.vertex), e.to);
  }

  std::string told;
  VertexAttribute<double> value;
  TriangleAttribute<int> number;

 private:
  void inherit(const SurfaceMesh& mesh, std::span<const TriangleSource> triangles) {
    for (const auto& [child, parent] : triangles) {
      EXPECT_TRUE(mesh.alive(child));
      EXPECT_FALSE(mesh.alive(parent));
      EXPECT_EQ(number[child], -1);
      number[child] = number[parent];
    }
  }
  double merged_ = 0;
};

class Operations : public ::testing::Test {
 protected:
  /// Runs one operation; expects it done, the mesh sound and the volumes kept.
  template <class Operation, class Element>
  void expect_done(SurfaceMesh& mesh, Element element, bool closed = true) {
    const auto volumes = region_volumes(mesh);
    const long euler = euler_characteristic(mesh);
    auto held = mesh.add_vertex_attribute<Hold>(Hold::none);
    Carrier carrier(mesh);
    const std::array<OperationObserver*, 1> observers = {&carrier};
    RemeshContext context(mesh, held, options, observers);
    Operation operation(context);
    const auto refusal = operation.attempt(element);
    ASSERT_FALSE(refusal.has_value()) << name(*refusal);
    EXPECT_EQ(audit(mesh, {.closed_regions = closed}).text(), "clean");
    EXPECT_EQ(euler_characteristic(mesh), euler);
    if (closed) {
      for (const auto& [region, before] : volumes) EXPECT_NEAR(volume(mesh, region), before, 1e-12);
    }
    for (Triangle t : mesh.triangles()) EXPECT_GE(carrier.number[t], 0);
    told = carrier.told;
    if (told.starts_with("split")) {
      for (Vertex v : mesh.vertices()) EXPECT_NEAR(carrier.value[v], linear(mesh.position(v)), 1e-14);
    }
  }

  RemeshOptions options = test::wide_bounds();
  std::string told;
};

TEST_F(Operations, SplitOfAFilmEdge) {
  SurfaceMesh mesh = test::analytic_double_bubble(1, 12);
  const std::size_t triangles = mesh.triangle_count();
  const Edge e = test::first_edge(mesh, [&](Edge f) { return !mesh.is_junction(f); });
  expect_done<EdgeSplit>(mesh, e);
  EXPECT_EQ(mesh.triangle_count(), triangles + 2);
  EXPECT_EQ(told, "split()");
}

TEST_F(Operations, SplitOfAPlateauBorderKeepsThreeFilms) {
  SurfaceMesh mesh = test::analytic_double_bubble(1, 12);
  const std::size_t triangles = mesh.triangle_count();
  const Edge e = test::first_edge(mesh, [&](Edge f) { return mesh.is_junction(f); });
  expect_done<EdgeSplit>(mesh, e);
  EXPECT_EQ(mesh.triangle_count(), triangles + 3);
  EXPECT_EQ(junction_edge_count(mesh), 13U);
}

TEST_F(Operations, SmoothSplitOfAPlateauBorderStaysOnTheCircle) {
  SurfaceMesh mesh = test::analytic_double_bubble(1, 24);
  options.use_butterfly = true;
  auto held = mesh.add_vertex_attribute<Hold>(Hold::none);
  RemeshContext context(mesh, held, options);
  EdgeSplit split(context);
  ASSERT_FALSE(split.attempt(test::first_edge(mesh, [&](Edge f) { return mesh.is_junction(f); })).has_value());
  EXPECT_NEAR(mesh.position(split.added()).norm(), std::sqrt(0.75), 1e-4);
  EXPECT_EQ(audit(mesh).text(), "clean");
}

TEST_F(Operations, SplitFallsBackToTheMidpointWhereTheSmoothPositionIsTaken) {
  SurfaceMesh mesh = test::globe(1, 8);
  const Edge e = mesh.find_edge(Vertex(40), Vertex(41));
  ASSERT_TRUE(e.valid());
  const Vec3 midpoint = 0.5 * (mesh.position(Vertex(40)) + mesh.position(Vertex(41)));
  test::add_pebble(mesh, midpoint * (1 + 0.5 * (1 / midpoint.norm() - 1)), 0.003, air);
  ASSERT_EQ(audit(mesh).text(), "clean");
  options.use_butterfly = true;
  auto held = mesh.add_vertex_attribute<Hold>(Hold::none);
  RemeshContext context(mesh, held, options);
  EdgeSplit split(context);
  ASSERT_FALSE(split.attempt(e).has_value());
  EXPECT_EQ(mesh.position(split.added()), midpoint);
  EXPECT_EQ(audit(mesh).text(), "clean");
}

TEST_F(Operations, CollapseWithinAFilmKeepsTheVolumeByAShiftAlongTheNormal) {
  SurfaceMesh mesh = test::globe(1, 8);
  const Edge e = mesh.find_edge(Vertex(40), Vertex(41));
  const std::size_t triangles = mesh.triangle_count();
  expect_done<EdgeCollapse>(mesh, e);
  EXPECT_EQ(mesh.triangle_count(), triangles - 2);
  EXPECT_EQ(told, "collapse()");
  EXPECT_GT(mesh.position(Vertex(40)).norm(), 1) << "further out than the sphere makes up for the lost corner";
}

TEST_F(Operations, CollapseAlongAPlateauBorderKeepsBothVolumes) {
  SurfaceMesh mesh = test::analytic_double_bubble(1, 16);
  const Edge e = test::first_edge(mesh, [&](Edge f) { return mesh.is_junction(f); });
  expect_done<EdgeCollapse>(mesh, e);
  EXPECT_EQ(junction_edge_count(mesh), 15U);
  for (Vertex v : mesh.vertices())
    if (mesh.is_junction(v)) {
      EXPECT_NEAR(mesh.position(v).norm(), std::sqrt(0.75), 0.03);
      EXPECT_NEAR(mesh.position(v)[0], 0, 1e-3);
    }
}

TEST_F(Operations, CollapseOntoABorderLeavesItInPlace) {
  SurfaceMesh mesh = test::analytic_double_bubble(1, 24);
  const Edge e = test::first_edge(mesh, [&](Edge f) {
    const auto [a, b] = mesh.vertices(f);
    return mesh.is_junction(a) != mesh.is_junction(b) && mesh.position(a)[0] == 0 && mesh.position(b)[0] == 0;
  });
  const Vertex rim = mesh.is_junction(mesh.vertices(e)[0]) ? mesh.vertices(e)[0] : mesh.vertices(e)[1];
  const Vec3 place = mesh.position(rim);
  expect_done<EdgeCollapse>(mesh, e);  // in the flat disc, so that the volumes stay
  ASSERT_TRUE(mesh.alive(rim));
  EXPECT_EQ(mesh.position(rim), place);
}

TEST_F(Operations, CollapseOntoAPlateauVertexLeavesItInPlace) {
  auto cube = test::cube_frame(4);
  SurfaceMesh& mesh = cube.mesh;
  ASSERT_EQ(mesh.position(Vertex(0)), Vec3(0, 0, 0));
  const Edge e =
      test::first_edge(mesh, [&](Edge f) { return mesh.is_junction(f) && mesh.vertices(f)[0] == Vertex(0); });
  expect_done<EdgeCollapse>(mesh, e, false);
  EXPECT_EQ(mesh.position(Vertex(0)), Vec3(0, 0, 0));
}

TEST_F(Operations, FlipOfAFlatKite) {
  SurfaceMesh mesh = test::two_triangles({-1, 0, 0}, {1, 0, 0}, {0, 0.4, 0}, {0, -0.4, 0});
  expect_done<EdgeFlip>(mesh, mesh.find_edge(Vertex(0), Vertex(1)), false);
  EXPECT_TRUE(mesh.find_edge(Vertex(2), Vertex(3)).valid());
  EXPECT_EQ(told, "flip()");
  for (Triangle t : mesh.triangles()) EXPECT_GT(area_vector(mesh, t)[2], 0);
}

TEST_F(Operations, FlipOnASphereKeepsTheVolume) {
  SurfaceMesh mesh = test::globe(1, 10);
  for (std::size_t k = 0; k < 20; ++k) {  // one of the rings of 20, turned by most of a segment
    Vec3 x = mesh.position(Vertex(1 + 4 * 20 + k));
    x.tail<2>() = Eigen::Rotation2D<double>(0.8 * std::numbers::pi / 10) * x.tail<2>();
    mesh.set_position(Vertex(1 + 4 * 20 + k), x);
  }
  ASSERT_EQ(audit(mesh).text(), "clean");
  const Edge e = test::first_edge(mesh, [&](Edge f) { return EdgeFlip::is_wanted(mesh, f); });
  ASSERT_TRUE(e.valid());
  expect_done<EdgeFlip>(mesh, e);
  EXPECT_FALSE(mesh.alive(e) && EdgeFlip::is_wanted(mesh, e));
}

TEST_F(Operations, FlipKeepsLabelsWhicheverWayTheTrianglesAreWritten) {
  SurfaceMesh mesh;
  for (const Vec3& x : {Vec3(-1, 0, 0), Vec3(1, 0, 0), Vec3(0, 0.4, 0), Vec3(0, -0.4, 0)}) mesh.add_vertex(x);
  mesh.add_triangle(Vertex(0), Vertex(1), Vertex(2), {Region(1), Region(2)});
  mesh.add_triangle(Vertex(0), Vertex(1), Vertex(3), {Region(2), Region(1)});  // normal down, region 1 still below
  expect_done<EdgeFlip>(mesh, mesh.find_edge(Vertex(0), Vertex(1)), false);
  for (Triangle t : mesh.triangles()) {
    const bool up = area_vector(mesh, t)[2] > 0;
    EXPECT_EQ(mesh.labels(t), (up ? Labels{Region(1), Region(2)} : Labels{Region(2), Region(1)}));
  }
}

TEST_F(Operations, SmoothingMovesAFilmVertexWithinItsPlane) {
  SurfaceMesh mesh = test::hexagonal_patch(1);
  mesh.set_position(Vertex(0), {0.6, 0.1, 0});
  expect_done<NullSpaceSmoothing>(mesh, Vertex(0), false);
  EXPECT_LT(mesh.position(Vertex(0)).norm(), 0.4);
  EXPECT_EQ(mesh.position(Vertex(0))[2], 0);
  EXPECT_EQ(told, "move()");
}

TEST_F(Operations, SmoothingMovesABorderVertexAlongTheBorder) {
  auto junction = test::triple_junction({120, 120, 120});
  const Vertex v = junction.border[3];
  junction.mesh.set_position(v, {0.7, 0, 0});
  expect_done<NullSpaceSmoothing>(junction.mesh, v, false);
  EXPECT_LT(std::abs(junction.mesh.position(v)[0]), 0.4);
  EXPECT_LT(junction.mesh.position(v).tail<2>().norm(), 1e-15);
}

TEST_F(Operations, SmoothingOnCurvedFilmsKeepsTheVolumes) {
  SurfaceMesh mesh = test::analytic_double_bubble(1, 16);
  for (Vertex v : mesh.vertices()) {  // a motion along the surface that bunches vertices up
    Vec3 x = mesh.position(v);
    x.tail<2>() = Eigen::Rotation2D<double>(0.12 * std::sin(5 * std::atan2(x[2], x[1]))) * x.tail<2>();
    mesh.set_position(v, x);
  }
  ASSERT_EQ(audit(mesh).text(), "clean");
  const auto before = region_volumes(mesh);
  auto held = mesh.add_vertex_attribute<Hold>(Hold::none);
  RemeshContext context(mesh, held, options);
  NullSpaceSmoothing smoothing(context);
  int moved = 0, moved_on_border = 0;
  for (Vertex v : mesh.vertices())
    if (!smoothing.attempt(v)) {
      ++moved;
      moved_on_border += mesh.is_junction(v);
    }
  EXPECT_GT(moved, 50);
  EXPECT_GT(moved_on_border, 3);
  for (const auto& [region, v] : before) EXPECT_NEAR(volume(mesh, region), v, 1e-13);
  EXPECT_EQ(audit(mesh).text(), "clean");
}

TEST_F(Operations, CollapseOfAHeldAndAFreeVertexGoesToTheHeldOne) {
  SurfaceMesh mesh = test::hexagonal_patch(2);
  auto held = mesh.add_vertex_attribute<Hold>(Hold::none);
  held[Vertex(0)] = Hold::all;
  const Edge e = mesh.edges(Vertex(0))[0];
  RemeshContext context(mesh, held, options);
  ASSERT_FALSE(EdgeCollapse(context).attempt(e).has_value());
  EXPECT_TRUE(mesh.alive(Vertex(0)));
  EXPECT_EQ(mesh.position(Vertex(0)), Vec3(0, 0, 0));
}

}  // namespace
}  // namespace lostopos
