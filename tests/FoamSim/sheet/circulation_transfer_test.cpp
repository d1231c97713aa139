// Γ through the tracker's operations, against the rules themselves applied to what was there before.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <set>

#include "FoamSim/sheet/circulation.h"
#include "LosTopos/mesh/measures.h"
#include "LosTopos/remeshing/edge_collapse.h"
#include "LosTopos/remeshing/edge_split.h"
#include "LosTopos/remeshing/remesher.h"
#include "tests/FoamSim/sheet/values_at.h"
#include "tests/support/film_meshes.h"

namespace foamsim {
namespace {

using lostopos::air;
using lostopos::CollapseEvent;
using lostopos::Edge;
using lostopos::FlipEvent;
using lostopos::Labels;
using lostopos::OperationObserver;
using lostopos::Region;
using lostopos::SplitEvent;
using lostopos::SurfaceMesh;
using lostopos::Triangle;
using lostopos::Vec3;
using lostopos::Vertex;

std::set<RegionPair> pairs_that_meet_at(const SurfaceMesh& mesh, Vertex v) {
  std::set<RegionPair> pairs;
  for (Triangle t : mesh.triangles(v)) pairs.insert(RegionPair(mesh.labels(t)));
  return pairs;
}

// (1 − t) a + t b for the pairs that meet at v; a pair that one does not have comes from the other.
void expect_mixed(const SurfaceMesh& mesh, const CirculationField& circulation, Vertex v, const Values& a,
                  const Values& b, double t) {
  const Values found = values_at(circulation, v);
  for (RegionPair pair : pairs_that_meet_at(mesh, v)) {
    ASSERT_TRUE(found.contains(pair));
    ASSERT_TRUE(a.contains(pair) || b.contains(pair)) << "no operation brings a pair from nowhere";
    const double from_a = a.contains(pair) ? a.at(pair) : b.at(pair);
    const double from_b = b.contains(pair) ? b.at(pair) : a.at(pair);
    EXPECT_NEAR(found.at(pair), (1 - t) * from_a + t * from_b, 1e-14);
  }
}

// Compares what becomes of Γ with the rules.
class CheckedTransfer final : public OperationObserver {
 public:
  explicit CheckedTransfer(CirculationField& circulation) : circulation_(circulation) {}

  void before_split(const SurfaceMesh&, const SplitEvent& e) override {
    a_ = values_at(circulation_, e.ends[0]);
    b_ = values_at(circulation_, e.ends[1]);
  }
  void after_split(const SurfaceMesh& mesh, const SplitEvent& e) override {
    ++splits;
    expect_mixed(mesh, circulation_, e.added, a_, b_, 0.5);
    EXPECT_EQ(values_at(circulation_, e.ends[0]), a_);
    EXPECT_EQ(values_at(circulation_, e.ends[1]), b_);
  }
  void before_collapse(const SurfaceMesh&, const CollapseEvent& e) override {
    a_ = values_at(circulation_, e.kept);
    b_ = values_at(circulation_, e.removed);
  }
  void after_collapse(const SurfaceMesh& mesh, const CollapseEvent& e) override {
    ++collapses;
    inner_collapses += e.t > 0 && e.t < 1 ? 1U : 0U;
    border_collapses += mesh.is_junction(e.kept) ? 1U : 0U;
    expect_mixed(mesh, circulation_, e.kept, a_, b_, e.t);
  }
  void after_flip(const SurfaceMesh&, const FlipEvent&) override { ++flips; }

  std::size_t splits = 0, collapses = 0, flips = 0, inner_collapses = 0, border_collapses = 0;

 private:
  CirculationField& circulation_;
  Values a_, b_;
};

// Every vertex holds exactly the pairs that meet there, sorted, with finite values that the order of regions turns.
void expect_sound(const SurfaceMesh& mesh, const CirculationField& circulation) {
  for (Vertex v : mesh.vertices()) {
    const auto pairs = pairs_that_meet_at(mesh, v);
    ASSERT_TRUE(std::ranges::equal(circulation.at(v), pairs, {}, &PairCirculation::pair)) << "vertex " << v.index();
    for (const auto& [pair, value] : circulation.at(v)) {
      ASSERT_TRUE(std::isfinite(value));
      ASSERT_EQ(circulation.get(v, {pair.low, pair.high}), value);
      ASSERT_EQ(circulation.get(v, {pair.high, pair.low}), -value);
    }
  }
}

void set_random(const SurfaceMesh& mesh, CirculationField& circulation, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (Vertex v : mesh.vertices())
    for (PairCirculation& held : circulation.at(v)) held.value = uniform(random);
}

// An affine function of position, another one for each pair.
double linear(RegionPair pair, const Vec3& x) {
  const double p = pair.low.index(), q = pair.high.index();
  return 1 + p + 10 * q + Vec3(1 + q, 2 - p * q, 0.5 * p - q).dot(x);
}

struct DoubleBubble {
  SurfaceMesh mesh = lostopos::test::analytic_double_bubble(1, 12);
  lostopos::VertexAttribute<lostopos::Hold> held = mesh.add_vertex_attribute<lostopos::Hold>(lostopos::Hold::none);
  CirculationField circulation{mesh};
  CheckedTransfer transfer{circulation};
  lostopos::RemeshOptions options{.target_edge = mean_edge_length(mesh)};

  // The edges with so many of their ends on the Plateau border; those with two, along it.
  std::vector<Edge> edges(int ends_on_border) const {
    std::vector<Edge> found;
    for (Edge e : mesh.edges()) {
      const auto [a, b] = mesh.vertices(e);
      const int ends = (mesh.is_junction(a) ? 1 : 0) + (mesh.is_junction(b) ? 1 : 0);
      if (ends == ends_on_border && mesh.is_junction(e) == (ends == 2)) found.push_back(e);
    }
    return found;
  }
  std::vector<OperationObserver*> observers{&transfer};
};

TEST(CirculationTransfer, SplitGivesTheMeanOfTheEndsForEachPair) {
  for (int ends_on_border : {0, 1, 2}) {
    DoubleBubble bubble;
    set_random(bubble.mesh, bubble.circulation, 1);
    const Edge e = bubble.edges(ends_on_border).front();
    const auto [a, b] = bubble.mesh.vertices(e);
    lostopos::RemeshContext context(bubble.mesh, bubble.held, bubble.options, bubble.observers);
    lostopos::EdgeSplit split(context);
    ASSERT_FALSE(split.attempt(e).has_value());
    const auto made = bubble.circulation.at(split.added());
    EXPECT_EQ(made.size(), ends_on_border == 2 ? 3U : 1U);
    for (const auto& [pair, value] : made) {
      const Labels pq{pair.low, pair.high};
      EXPECT_NEAR(value, (bubble.circulation.get(a, pq) + bubble.circulation.get(b, pq)) / 2, 1e-15);
    }
    expect_sound(bubble.mesh, bubble.circulation);
    EXPECT_EQ(bubble.transfer.splits, 1U);
  }
}

TEST(CirculationTransfer, CollapseInterpolatesForEachPair) {
  for (int ends_on_border : {0, 1, 2}) {
    DoubleBubble bubble;
    set_random(bubble.mesh, bubble.circulation, 2);
    bubble.options.target_edge *= 2;  // so that no edge is too long afterwards
    lostopos::RemeshContext context(bubble.mesh, bubble.held, bubble.options, bubble.observers);
    lostopos::EdgeCollapse collapse(context);
    bool done = false;
    for (Edge e : bubble.edges(ends_on_border))
      if (!done) done = !collapse.attempt(e).has_value();  // the bounds refuse some
    ASSERT_TRUE(done) << ends_on_border;
    EXPECT_EQ(bubble.circulation.at(collapse.kept()).size(), ends_on_border == 0 ? 1U : 3U);
    EXPECT_EQ(bubble.transfer.inner_collapses, ends_on_border == 1 ? 0U : 1U) << "a border vertex stays";
    expect_sound(bubble.mesh, bubble.circulation);
    EXPECT_EQ(bubble.transfer.collapses, 1U);
  }
}

TEST(CirculationTransfer, CollapseTakesAPairThatOneVertexHadFromThere) {
  DoubleBubble bubble;
  set_random(bubble.mesh, bubble.circulation, 3);
  const Edge e = bubble.edges(1).front();
  auto [film, border] = bubble.mesh.vertices(e);
  if (bubble.mesh.is_junction(film)) std::swap(film, border);
  const Values of_film = values_at(bubble.circulation, film), of_border = values_at(bubble.circulation, border);
  const CollapseEvent event{e, film, border, 0.3, Vec3::Zero(), {}};
  bubble.mesh.carry_attributes(&OperationObserver::before_collapse, event);
  for (Triangle t : std::vector<Triangle>(bubble.mesh.triangles(border).begin(), bubble.mesh.triangles(border).end())) {
    auto v = bubble.mesh.vertices(t);
    const Labels labels = bubble.mesh.labels(t);
    bubble.mesh.remove_triangle(t);
    std::ranges::replace(v, border, film);
    if (v[0] != v[1] && v[1] != v[2] && v[2] != v[0]) bubble.mesh.add_triangle(v[0], v[1], v[2], labels);
  }
  bubble.mesh.carry_attributes(&OperationObserver::after_collapse, event);
  const Values mixed = values_at(bubble.circulation, film);
  ASSERT_EQ(mixed.size(), 3U);
  for (const auto& [pair, value] : mixed)
    EXPECT_NEAR(value, of_film.contains(pair) ? 0.7 * of_film.at(pair) + 0.3 * of_border.at(pair) : of_border.at(pair),
                1e-15);
}

TEST(CirculationTransfer, APairThatNobodyHadIsTheMeanOfTheNeighboursThatHoldIt) {
  DoubleBubble bubble;
  SurfaceMesh& mesh = bubble.mesh;
  set_random(mesh, bubble.circulation, 4);
  // A triangle of the right bubble's cap with two vertices on the border comes to bound the left one.
  const Labels left{Region(1), air};
  Triangle t;
  for (Triangle candidate : mesh.triangles()) {
    int on_border = 0;
    for (Vertex v : mesh.vertices(candidate)) on_border += mesh.is_junction(v) ? 1 : 0;
    if (on_border == 2 && RegionPair(mesh.labels(candidate)) == RegionPair(Region(2), air)) t = candidate;
  }
  ASSERT_TRUE(t.valid());
  Vertex inner;
  for (Vertex v : mesh.vertices(t))
    if (!mesh.is_junction(v)) inner = v;
  const double kept = bubble.circulation.get(inner, {Region(2), air});
  double sum = 0, count = 0;
  for (Edge e : mesh.edges(inner))
    if (const Vertex other = mesh.other_vertex(e, inner); mesh.is_junction(other)) {
      sum += bubble.circulation.get(other, left);
      ++count;
    }
  ASSERT_GE(count, 2);
  mesh.set_labels(t, left);
  const auto& v = mesh.vertices(t);
  const FlipEvent event{Edge(), mesh.edges(t)[0], {v[0], v[1]}, {v[2], v[0]}, Vertex(), Vec3::Zero(), {}};
  mesh.carry_attributes(&OperationObserver::after_flip, event);
  EXPECT_NEAR(bubble.circulation.get(inner, left), sum / count, 1e-15);
  EXPECT_EQ(bubble.circulation.get(inner, {Region(2), air}), kept);
  expect_sound(mesh, bubble.circulation);
}

void expect_linear_through_splits(SurfaceMesh mesh, std::span<const Vertex> held_vertices) {
  auto held = mesh.add_vertex_attribute<lostopos::Hold>(lostopos::Hold::none);
  for (Vertex v : held_vertices) held[v] = lostopos::Hold::all;
  CirculationField circulation(mesh);
  for (Vertex v : mesh.vertices())
    for (auto& [pair, value] : circulation.at(v)) value = linear(pair, mesh.position(v));
  CheckedTransfer transfer(circulation);
  lostopos::RemeshOptions options{.target_edge = 0.3 * mean_edge_length(mesh)};
  options.collapse = options.flip = options.smoothing = false;
  options.max_aggressive_rounds = 0;
  const std::size_t before = mesh.vertex_count();
  lostopos::Remesher(mesh, held, options, {&transfer}).run();
  EXPECT_GT(transfer.splits, before);
  std::size_t at_junctions = 0;
  for (Vertex v : mesh.vertices()) {
    at_junctions += v.index() >= before && circulation.at(v).size() >= 3 ? 1U : 0U;
    for (const auto& [pair, value] : circulation.at(v)) EXPECT_NEAR(value, linear(pair, mesh.position(v)), 1e-12);
  }
  EXPECT_GT(at_junctions, 10U);
  expect_sound(mesh, circulation);
}

TEST(CirculationTransfer, ALinearFunctionStaysLinearThroughMidpointSplits) {
  expect_linear_through_splits(lostopos::test::analytic_double_bubble(1, 12), {});
  auto cube = lostopos::test::cube_frame(4);
  expect_linear_through_splits(std::move(cube.mesh), cube.frame);
}

// Refines, coarsens and stretches at random. Every rule is a mean with weights ≥ 0: no value leaves the range of its
// pair's values at the start, and one that was the same everywhere stays so.
void remesh_at_random(SurfaceMesh mesh, std::span<const Vertex> held_vertices, bool constant, unsigned seed) {
  std::mt19937 random(seed);
  auto held = mesh.add_vertex_attribute<lostopos::Hold>(lostopos::Hold::none);
  for (Vertex v : held_vertices) held[v] = lostopos::Hold::all;
  CirculationField circulation(mesh);
  set_random(mesh, circulation, seed);
  auto same = [](RegionPair pair) { return 1.0 + pair.low.index() + 0.1 * pair.high.index(); };
  if (constant)
    for (Vertex v : mesh.vertices())
      for (auto& [pair, value] : circulation.at(v)) value = same(pair);
  CheckedTransfer transfer(circulation);
  const double h = mean_edge_length(mesh);
  for (int pass = 0; pass < 12; ++pass) {
    if (held_vertices.empty()) {  // a map that cannot make the surface intersect itself
      const double f = std::uniform_real_distribution<double>(0.9, 1.1)(random);
      for (Vertex v : mesh.vertices())
        mesh.set_position(v, mesh.position(v).cwiseProduct(Vec3(1 / std::sqrt(f), f, 1 / std::sqrt(f))));
    }
    lostopos::RemeshOptions options{.target_edge = std::uniform_real_distribution<double>(0.6, 1.6)(random) * h};
    lostopos::Remesher(mesh, held, options, {&transfer}).run();
    if (pass % 3 == 2) mesh.compact();
    expect_sound(mesh, circulation);
    for (Vertex v : mesh.vertices())
      for (const auto& [pair, value] : circulation.at(v)) {
        ASSERT_LE(std::abs(value), constant ? 10 : 1 + 1e-12);
        if (constant) {
          ASSERT_NEAR(value, same(pair), 1e-12);
        }
      }
  }
  EXPECT_GT(transfer.splits, 50U);
  EXPECT_GT(transfer.collapses, 50U);
  EXPECT_GT(transfer.flips, 50U);
  EXPECT_GT(transfer.border_collapses, 5U);
  EXPECT_GT(transfer.inner_collapses, 20U);
}

TEST(CirculationTransfer, HoldsThePairsThatMeetAfterRandomRemeshingOfADoubleBubble) {
  for (bool constant : {false, true}) remesh_at_random(lostopos::test::analytic_double_bubble(1, 16), {}, constant, 11);
}

TEST(CirculationTransfer, HoldsThePairsThatMeetAfterRandomRemeshingOfACubeFrame) {
  for (bool constant : {false, true}) {
    auto cube = lostopos::test::cube_frame(6);
    remesh_at_random(std::move(cube.mesh), cube.frame, constant, 12);
  }
}

}  // namespace
}  // namespace foamsim
