// Random sequences of operations with merges, separations and vanishing regions among them: the mesh stays sound, and
// is the same to the bit when it says no.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "LosTopos/mesh/audit.h"
#include "LosTopos/mesh/measures.h"
#include "LosTopos/remeshing/edge_collapse.h"
#include "LosTopos/remeshing/edge_flip.h"
#include "LosTopos/remeshing/edge_split.h"
#include "LosTopos/remeshing/null_space_smoothing.h"
#include "LosTopos/shapes/voronoi_foam.h"
#include "LosTopos/topology/near_pairs.h"
#include "LosTopos/topology/place_merge.h"
#include "LosTopos/topology/vertex_separation.h"
#include "tests/LosTopos/remeshing/patches.h"
#include "tests/LosTopos/topology/clusters.h"
#include "tests/support/film_meshes.h"

namespace lostopos {
namespace {

struct Step {
  int kind;
  std::uint32_t element;
  bool exact;
};
constexpr int kinds = 8;

rc::Gen<std::vector<Step>> steps() {
  const auto step = rc::gen::construct<Step>(rc::gen::inRange(0, kinds), rc::gen::arbitrary<std::uint32_t>(),
                                             rc::gen::arbitrary<bool>());
  return rc::gen::resize(60, rc::gen::container<std::vector<Step>>(step));
}

template <class Range>
auto element(const Range& range, std::size_t count, std::uint32_t choice) {
  auto it = range.begin();
  std::advance(it, choice % count);
  return *it;
}

std::optional<Refusal> snap(RemeshContext& context, double distance, const Step& step) {
  const SurfaceMesh& mesh = context.mesh;
  const auto pairs = near_pairs(mesh, distance);
  if (pairs.empty()) return Refusal::not_better;
  const NearPair& near = pairs[step.element % pairs.size()];
  const auto& w = near.weights;
  const bool edges = near.pair.kind == ElementPair::Kind::edge_edge;
  const Site a = edges ? site_on(mesh, Edge(near.pair.first), w[1]) : site_at(mesh, Vertex(near.pair.first));
  const Site b = edges ? site_on(mesh, Edge(near.pair.second), w[3])
                       : site_in(mesh, Triangle(near.pair.second), {w[1], w[2], w[3]});
  const double reach = step.exact ? 0 : distance;
  return PlaceMerge(context).attempt(settled(mesh, a, reach), settled(mesh, b, reach), {});
}

std::optional<Refusal> perform(RemeshContext& context, double distance, const Step& step) {
  const SurfaceMesh& mesh = context.mesh;
  const Edge e = element(mesh.edges(), mesh.edge_count(), step.element);
  const Vertex v = element(mesh.vertices(), mesh.vertex_count(), step.element);
  const auto [a, b] = mesh.vertices(e);
  switch (step.kind) {
    case 0:
      return EdgeSplit(context).attempt(e);
    case 1:
      return EdgeCollapse(context).attempt(e);
    case 2:
      return EdgeFlip(context).attempt(e);
    case 3:
      return NullSpaceSmoothing(context).attempt(v);
    case 4:
      return PlaceMerge(context).attempt(site_at(mesh, a), site_at(mesh, b),
                                         {.joined_vertices = true, .keeps_orientation = step.exact});
    case 5: {
      VertexSeparation separation(context, SeparationRule::area, distance, {});
      for (Vertex candidate : mesh.vertices())
        if (!is_complete(mesh, candidate)) return separation.attempt(candidate);
      return Refusal::not_better;
    }
    default:
      return snap(context, distance, step);
  }
}

// Attributes that go along: what has to hold of them after every operation.
struct Cargo {
  explicit Cargo(SurfaceMesh& of) : mesh(of) {
    for (Vertex v : mesh.vertices()) {
      density[v] = 1 + 0.5 * std::sin(3.0 * v.index());
      share[v] = std::cos(7.0 * v.index());
    }
    for (Triangle t : mesh.triangles()) marked[t] = 1;
    amount = integral();
  }
  double integral() const {
    double sum = 0;
    for (Triangle t : mesh.triangles())
      for (Vertex v : mesh.vertices(t)) sum += area(mesh, t) / 3 * density[v];
    return sum;
  }
  bool holds() const {
    for (Vertex v : mesh.vertices())
      if (!(std::abs(share[v]) <= 1 + 1e-12 && density[v] > 0)) return false;
    for (Triangle t : mesh.triangles())
      if (marked[t] != 1) return false;
    return std::abs(integral() - amount) <= 1e-11 * amount;
  }
  SurfaceMesh& mesh;
  VertexAttribute<double> density = mesh.add_vertex_attribute<double>("density", carry::conserve);
  VertexAttribute<double> share = mesh.add_vertex_attribute<double>("share", carry::interpolate, 100);
  TriangleAttribute<int> marked = mesh.add_triangle_attribute<int>("marked", carry::copy);
  EdgeAttribute<int> line = mesh.add_edge_attribute<int>("line", carry::copy);
  double amount = 0;
};

void run_sequence(SurfaceMesh mesh, std::span<const Vertex> held_vertices, bool closed) {
  const Cargo cargo(mesh);
  auto held = mesh.add_vertex_attribute<Hold>(Hold::none);
  for (Vertex v : held_vertices) held[v] = Hold::all;
  const std::vector<Vec3> start(mesh.positions().begin(), mesh.positions().end());
  const double distance = 0.4 * mean_edge_length(mesh);
  RemeshContext context(mesh, held, test::wide_bounds());
  for (const Step& step : *steps()) {
    if (mesh.triangle_count() == 0) return;
    const auto before = mesh.state();
    if (perform(context, distance, step)) {
      RC_ASSERT(test::same_bits(before, mesh.state()));
      continue;
    }
    const AuditReport report = audit(mesh, {.closed_regions = closed});
    RC_ASSERT(report.text() == "clean");
    RC_ASSERT(mesh.triangle_count() == 0 || cargo.holds());
  }
  for (Vertex v : held_vertices) {
    RC_ASSERT(mesh.alive(v));
    RC_ASSERT(mesh.position(v) == start[v.index()]);
  }
}

RC_GTEST_PROP(MergeSequence, OnDoubleBubbles, ()) {
  run_sequence(test::analytic_double_bubble(1, *rc::gen::inRange(6, 14)), {}, true);
}

RC_GTEST_PROP(MergeSequence, OnTwoSpheresThatAreClose, ()) {
  const Region right(*rc::gen::arbitrary<bool>() ? 1u : 2u);
  run_sequence(test::two_spheres(1, 0.1, Region(1), right), {}, true);
}

RC_GTEST_PROP(MergeSequence, OnACubeFrameOfFilms, ()) {
  auto cube = test::cube_frame(*rc::gen::inRange(1, 5));
  run_sequence(std::move(cube.mesh), cube.frame, false);
}

RC_GTEST_PROP(MergeSequence, OnAFoamOfTwentyBubbles, ()) {
  const auto seed = *rc::gen::inRange<std::uint64_t>(1, 1000);
  run_sequence(voronoi_foam({.cells = 20, .seed = seed}), {}, true);
}

}  // namespace
}  // namespace lostopos
