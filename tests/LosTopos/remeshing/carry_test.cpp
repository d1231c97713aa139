// Each policy of named attributes through the operations of remeshing.
#include <gtest/gtest.h>

#include "LosTopos/mesh/measures.h"
#include "LosTopos/remeshing/edge_collapse.h"
#include "LosTopos/remeshing/edge_flip.h"
#include "LosTopos/remeshing/edge_split.h"
#include "LosTopos/remeshing/hold_transfer.h"
#include "LosTopos/remeshing/null_space_smoothing.h"
#include "tests/LosTopos/remeshing/patches.h"
#include "tests/support/film_meshes.h"

namespace lostopos {
namespace {

// The largest of what an element comes from, and how often it was asked.
class Largest final : public CarryPolicy<Vertex, double> {
 public:
  void after_split(const SurfaceMesh&, const SplitEvent& e) override {
    value(e.added) = std::max(value(e.ends[0]), value(e.ends[1]));
  }
  void after_collapse(const SurfaceMesh&, const CollapseEvent& e) override {
    value(e.kept) = std::max(value(e.kept), value(e.removed));
  }
};

double integral(const SurfaceMesh& mesh, const VertexAttribute<double>& values) {
  double sum = 0;
  for (Triangle t : mesh.triangles())
    for (Vertex v : mesh.vertices(t)) sum += area(mesh, t) / 3 * values[v];
  return sum;
}

struct Patch {
  explicit Patch(SurfaceMesh m) : mesh(std::move(m)) {
    for (Vertex v : mesh.vertices()) {
      mixed[v] = peak[v] = density[v] = 1.0 + v.index();
      place[v] = mesh.position(v);
      name[v] = static_cast<int>(v.index());
    }
    for (Triangle t : mesh.triangles()) parent[t] = static_cast<int>(t.index());
    for (Edge e : mesh.edges()) line[e] = static_cast<int>(e.index());
  }
  // One of the edges at vertex 0.
  Edge spoke(std::size_t k) const { return mesh.edges(Vertex(0))[k]; }
  Vertex end_of(std::size_t k) const { return mesh.other_vertex(spoke(k), Vertex(0)); }
  // Of the attribute `mixed` half-way along it.
  double half_way(std::size_t k) const { return 0.5 * (1 + (1.0 + end_of(k).index())); }
  SurfaceMesh mesh;
  VertexAttribute<double> mixed = mesh.add_vertex_attribute<double>("mixed", carry::interpolate);
  VertexAttribute<Vec3> place = mesh.add_vertex_attribute<Vec3>("place", carry::interpolate, Vec3::Zero());
  VertexAttribute<double> peak = mesh.add_vertex_attribute<double>("peak", std::make_unique<Largest>());
  VertexAttribute<double> density = mesh.add_vertex_attribute<double>("density", carry::conserve);
  VertexAttribute<int> name = mesh.add_vertex_attribute<int>("name", carry::copy, -1);
  TriangleAttribute<int> parent = mesh.add_triangle_attribute<int>("parent", carry::copy, -1);
  EdgeAttribute<int> line = mesh.add_edge_attribute<int>("line", carry::copy, -1);
  VertexAttribute<double> work = mesh.add_vertex_attribute<double>(-5);
  VertexAttribute<Hold> held = add_hold_attribute(mesh);
  RemeshContext context{mesh, held, test::wide_bounds()};
};

TEST(Carry, ThroughASplit) {
  Patch p(test::hexagonal_patch(3));
  const Edge e = p.spoke(0);
  const auto ends = p.mesh.vertices(e);
  const double middle = p.half_way(0), largest = 1.0 + p.end_of(0).index();
  const int line = p.line[e];
  const double before = integral(p.mesh, p.density);
  EdgeSplit split(p.context);
  ASSERT_FALSE(split.attempt(e));
  const Vertex added = split.added();
  EXPECT_EQ(p.mixed[added], middle);
  EXPECT_EQ(p.place[added], Vec3(0.5 * (p.mesh.position(ends[0]) + p.mesh.position(ends[1]))));
  EXPECT_EQ(p.peak[added], largest);
  EXPECT_EQ(p.name[added], static_cast<int>(ends[0].index()));
  EXPECT_EQ(p.work[added], -5) << "work arrays follow nothing";
  EXPECT_NEAR(integral(p.mesh, p.density), before, 1e-13 * before);
  EXPECT_GT(p.density[added], 0);
  for (Vertex end : ends) EXPECT_EQ(p.line[p.mesh.find_edge(end, added)], line);
  for (Triangle t : p.mesh.triangles(added)) EXPECT_GE(p.parent[t], 0);
  for (Edge fresh : p.mesh.edges(added))
    EXPECT_TRUE(p.line[fresh] == line || p.line[fresh] == -1) << "within a triangle an edge is new";
}

TEST(Carry, ThroughACollapse) {
  Patch p(test::hexagonal_patch(3));
  const double middle = p.half_way(0), largest = 1.0 + p.end_of(0).index();
  const double before = integral(p.mesh, p.density);
  EdgeCollapse collapse(p.context);
  ASSERT_FALSE(collapse.attempt(p.spoke(0)));
  EXPECT_EQ(p.mixed[collapse.kept()], middle);
  EXPECT_EQ(p.peak[collapse.kept()], largest);
  EXPECT_EQ(p.name[collapse.kept()], static_cast<int>(collapse.kept().index()));
  EXPECT_NEAR(integral(p.mesh, p.density), before, 1e-13 * before);
  for (Triangle t : p.mesh.triangles()) EXPECT_GE(p.parent[t], 0);
  for (Edge left : p.mesh.edges()) EXPECT_GE(p.line[left], 0) << "every edge goes on from one that was there";
}

TEST(Carry, ThroughAFlip) {
  Patch p(test::two_triangles({0, 0, 0}, {4, 0, 0}, {2, 0.5, 0}, {2, -0.5, 0}));
  const Edge e = p.mesh.find_edge(Vertex(0), Vertex(1));
  const int line = p.line[e];
  const double before = integral(p.mesh, p.density);
  EdgeFlip flip(p.context);
  ASSERT_FALSE(flip.attempt(e));
  EXPECT_EQ(p.line[flip.added()], line);
  EXPECT_NEAR(integral(p.mesh, p.density), before, 1e-13 * before);
  std::vector<int> parents;
  for (Triangle t : p.mesh.triangles()) parents.push_back(p.parent[t]);
  std::ranges::sort(parents);
  EXPECT_EQ(parents, (std::vector<int>{0, 1}));
  for (Vertex v : p.mesh.vertices()) EXPECT_EQ(p.mixed[v], 1.0 + v.index());
}

TEST(Carry, ThroughSmoothing) {
  SurfaceMesh mesh = test::hexagonal_patch(2);
  mesh.set_position(Vertex(0), Vec3(0.6, 0.1, 0));
  Patch p(std::move(mesh));
  const double before = integral(p.mesh, p.density);
  ASSERT_FALSE(NullSpaceSmoothing(p.context).attempt(Vertex(0)));
  EXPECT_EQ(p.mixed[Vertex(0)], 1);
  EXPECT_NEAR(integral(p.mesh, p.density), before, 1e-13 * before);
}

TEST(Carry, ConservesZeroAndTheSignOfOneSignedValues) {
  Patch p(test::hexagonal_patch(3));
  for (Vertex v : p.mesh.vertices()) p.density[v] = v.index() == 0 ? 2 : 0;
  const double before = integral(p.mesh, p.density);
  for (int round = 0; round < 3; ++round) {
    ASSERT_FALSE(EdgeSplit(p.context).attempt(p.spoke(0)));
    for (Vertex v : p.mesh.vertices()) EXPECT_GE(p.density[v], 0);
  }
  EXPECT_NEAR(integral(p.mesh, p.density), before, 1e-13 * before);
  for (Vertex v : p.mesh.vertices()) p.density[v] = 0;
  ASSERT_FALSE(EdgeCollapse(p.context).attempt(p.spoke(0)));
  for (Vertex v : p.mesh.vertices()) EXPECT_EQ(p.density[v], 0);
}

TEST(Carry, ConstantsStayConstantOnAFlatPatch) {
  Patch p(test::hexagonal_patch(3));
  for (Vertex v : p.mesh.vertices()) p.density[v] = 3;
  ASSERT_FALSE(EdgeSplit(p.context).attempt(p.spoke(0)));
  ASSERT_FALSE(EdgeCollapse(p.context).attempt(p.spoke(0)));
  for (Vertex v : p.mesh.vertices()) EXPECT_NEAR(p.density[v], 3, 1e-13);
}

TEST(Carry, ObserversSeeTheValuesBeforeAndAfter) {
  struct Watcher final : OperationObserver {
    explicit Watcher(Patch& patch) : p(patch) {}
    void before_collapse(const SurfaceMesh&, const CollapseEvent& e) override {
      EXPECT_EQ(p.mixed[e.kept], 1.0 + e.kept.index());
      ++told;
    }
    void after_collapse(const SurfaceMesh&, const CollapseEvent& e) override {
      EXPECT_EQ(p.mixed[e.kept], middle);
      ++told;
    }
    Patch& p;
    int told = 0;
    double middle = p.half_way(0);
  };
  Patch p(test::hexagonal_patch(3));
  Watcher watcher(p);
  const std::array<OperationObserver*, 1> observers{&watcher};
  RemeshContext context(p.mesh, p.held, test::wide_bounds(), observers);
  ASSERT_FALSE(EdgeCollapse(context).attempt(p.spoke(0)));
  EXPECT_EQ(watcher.told, 2);
}

}  // namespace
}  // namespace lostopos
