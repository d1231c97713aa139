// What the tracker may do next to what is held, and what not.
#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "LosTopos/mesh/audit.h"
#include "LosTopos/surface_tracker.h"

namespace lostopos {
namespace {

// A disc of film on a ring of n edges, and a solid cone behind it.
SurfaceMesh wand(int n) {
  SurfaceMesh mesh;
  std::vector<Vertex> ring;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    ring.push_back(mesh.add_vertex({0, std::cos(angle), std::sin(angle)}));
  }
  const Vertex middle = mesh.add_vertex({0, 0, 0}), tip = mesh.add_vertex({-1, 0, 0});
  for (int i = 0; i < n; ++i) {
    const Vertex a = ring[i], b = ring[(i + 1) % n];
    mesh.add_triangle(middle, a, b, {Region(1), Region(0)});
    mesh.add_triangle(tip, a, b, {Region(0), Region(1)});
  }
  return mesh;
}

// Looks at every operation, and counts.
class Watch final : public OperationObserver {
 public:
  explicit Watch(const SurfaceTracker& tracker) : tracker_(tracker) {}

  void before_split(const SurfaceMesh&, const SplitEvent& e) override {
    EXPECT_FALSE(held(e.ends[0]) && held(e.ends[1]));
    at_wire_ = held(e.ends[0]) || held(e.ends[1]);
  }
  void after_split(const SurfaceMesh&, const SplitEvent& e) override {
    EXPECT_EQ(tracker_.held()[e.added], Hold::none);
    if (at_wire_) ++splits;
  }
  void before_collapse(const SurfaceMesh& mesh, const CollapseEvent& e) override {
    EXPECT_FALSE(held(e.kept) || held(e.removed));
    const auto near = [&](Vertex v) {
      return std::ranges::any_of(mesh.edges(v), [&](Edge edge) { return held(mesh.other_vertex(edge, v)); });
    };
    if (near(e.kept) || near(e.removed)) ++collapses;
  }
  void before_flip(const SurfaceMesh& mesh, const FlipEvent& e) override {
    for (Triangle t : mesh.triangles(e.edge)) EXPECT_EQ(tracker_.solid()[t], 0);
    if (held(e.old_ends[0]) || held(e.old_ends[1]) || held(e.new_ends[0]) || held(e.new_ends[1])) ++flips;
    EXPECT_FALSE(e.moved.valid() && held(e.moved));
  }
  void before_move(const SurfaceMesh&, const MoveEvent& e) override {
    EXPECT_FALSE(held(e.vertex));
    ++moves;
  }
  void before_merge(const SurfaceMesh& mesh, const MergeEvent& e) override {
    stays_.reset();
    for (const Place& place : e.places)
      if (place.count == 1 && held(place.vertices[0])) stays_ = mesh.position(place.vertices[0]);
  }
  void after_merge(const SurfaceMesh& mesh, const MergeEvent& e) override {
    if (!stays_ || !mesh.alive(e.result)) return;
    EXPECT_EQ(mesh.position(e.result), *stays_);
    EXPECT_TRUE(held(e.result));
    ++merges;
  }

  int splits = 0, collapses = 0, flips = 0, moves = 0, merges = 0;

 private:
  bool held(Vertex v) const { return is_held(tracker_.held()[v]); }
  const SurfaceTracker& tracker_;
  bool at_wire_ = false;
  std::optional<Vec3> stays_;
};

TEST(RemeshingNearWires, KeepsWhatIsHeldAndSolid) {
  TrackerOptions options{.resolution = 0.2};
  options.remesh.collapse_to_held = false;
  options.topology.enabled = true;
  SurfaceTracker tracker(wand(12), options);
  for (Vertex v : tracker.mesh().vertices()) tracker.held()[v] = v == Vertex(12) ? Hold::none : Hold::all;
  for (Triangle t : tracker.mesh().triangles())
    tracker.solid()[t] = tracker.mesh().vertices(t)[0] == Vertex(13) ? 1 : 0;
  Watch watch(tracker);
  const ObserverToken token = tracker.add_observer(watch);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> shake(-0.03, 0.03);
  for (int step = 0; step < 60; ++step) {
    // The wand goes back and forth, and the film bulges and comes near it again.
    const double motion = step < 30 ? -0.04 : 0.04;
    std::vector<Vec3> to(tracker.mesh().positions().begin(), tracker.mesh().positions().end());
    for (Vertex v : tracker.mesh().vertices()) {
      const bool held = is_held(tracker.held()[v]);
      to[v.index()] += held ? Vec3(motion, 0, 0) : Vec3(shake(random), shake(random), shake(random));
    }
    tracker.step(to);
    int held = 0, solid = 0;
    for (Vertex v : tracker.mesh().vertices()) held += is_held(tracker.held()[v]) ? 1 : 0;
    for (Triangle t : tracker.mesh().triangles()) {
      if (tracker.solid()[t] == 0) continue;
      ++solid;
      for (Vertex v : tracker.mesh().vertices(t)) EXPECT_TRUE(is_held(tracker.held()[v]));
    }
    ASSERT_EQ(held, 13) << step;
    ASSERT_EQ(solid, 12) << step;
  }
  EXPECT_TRUE(audit(tracker.mesh()).clean());
  // Else it would say little.
  EXPECT_GT(watch.splits, 10);
  EXPECT_GT(watch.collapses, 10);
  EXPECT_GT(watch.flips, 10);
  EXPECT_GT(watch.moves, 10);
}

}  // namespace
}  // namespace lostopos
