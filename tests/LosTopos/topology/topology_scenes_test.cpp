// What a user sees of the topology changes, with the whole tracker at work and an audit after every step.
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "LosTopos/mesh/audit.h"
#include "LosTopos/mesh/measures.h"
#include "LosTopos/shapes/solids.h"
#include "LosTopos/shapes/voronoi_foam.h"
#include "LosTopos/surface_tracker.h"
#include "LosTopos/topology/region_parts.h"
#include "tests/LosTopos/remeshing/patches.h"
#include "tests/LosTopos/topology/clusters.h"

namespace lostopos {
namespace {

SurfaceTracker tracker_of(SurfaceMesh mesh, SeparationRule rule) {
  TrackerOptions options;
  options.resolution = mean_edge_length(mesh);
  options.topology.enabled = true;
  options.topology.separation = rule;
  return SurfaceTracker(std::move(mesh), options);
}

template <class Velocity>
TopologyStatistics run(SurfaceTracker& tracker, int steps, const Velocity& displacement) {
  TopologyStatistics sum;
  for (int step = 0; step < steps; ++step) {
    std::vector<Vec3> predicted(tracker.mesh().positions().begin(), tracker.mesh().positions().end());
    for (Vertex v : tracker.mesh().vertices()) predicted[v.index()] += displacement(tracker.mesh().position(v));
    sum += tracker.step(predicted).topology;
    EXPECT_EQ(audit(tracker.mesh()).text(), "clean") << "step " << step;
    if (testing::Test::HasFailure()) return sum;
  }
  return sum;
}

// Towards x = 0 from both sides, by 0.02 a step and slower close to it.
Vec3 squeeze(const Vec3& x) {
  return {-0.02 * std::clamp(x[0] / 0.05, -1.0, 1.0), 0, 0};
}

TEST(Topology, TwoBubblesThatArePressedTogetherShareOneWall) {
  SurfaceTracker tracker = tracker_of(test::two_spheres(2, 0.2, Region(1), Region(2)), SeparationRule::flow);
  const TopologyStatistics sum = run(tracker, 15, squeeze);
  const SurfaceMesh& mesh = tracker.mesh();
  EXPECT_GT(sum[TopologyOperation::snap].done, 3u);
  EXPECT_EQ(regions(mesh).size(), 3u);
  EXPECT_EQ(euler_characteristic(mesh), 3);
  // Two spheres that overlap by 2 · 0.2 have a wall of radius sqrt(1 − 0.8²).
  EXPECT_NEAR(test::film_area(mesh, Region(1), Region(2)), std::numbers::pi * 0.36, 0.45);
  for (Edge e : mesh.edges()) EXPECT_LE(mesh.triangles(e).size(), 3u);
}

// A long step in which surfaces collide is done in parts, and what does not follow it any more stays where the first
// part has brought it.
TEST(Topology, VerticesThatStopFollowingALongStepStay) {
  for (const bool follow : {true, false}) {
    SurfaceTracker tracker = tracker_of(test::two_spheres(2, 0.2, Region(1), Region(2)), SeparationRule::flow);
    const auto tip_of = [&] {
      return std::ranges::max(tracker.mesh().positions(), {}, [](const Vec3& x) { return x[0]; })[0];
    };
    const double before = tip_of();
    std::vector<Vec3> predicted(tracker.mesh().positions().begin(), tracker.mesh().positions().end());
    for (Vec3& x : predicted) x[0] -= std::copysign(0.2, x[0]);
    const TrackerStep done = tracker.step(predicted, [follow](Vertex) { return follow; });
    ASSERT_GT(done.parts, 2);
    EXPECT_EQ(done.topology[TopologyOperation::snap].done > 0, follow);
    EXPECT_NEAR(before - tip_of(), follow ? 0.2 : 0.2 / done.parts, 1e-3);
    EXPECT_EQ(audit(tracker.mesh()).text(), "clean");
  }
}

TEST(Topology, TwoSpheresOfOneRegionBecomeOneSurface) {
  SurfaceTracker tracker = tracker_of(test::two_spheres(2, 0.2, Region(1), Region(1)), SeparationRule::flow);
  run(tracker, 15, squeeze);
  EXPECT_EQ(regions(tracker.mesh()).size(), 2u);
  EXPECT_EQ(euler_characteristic(tracker.mesh()), 2);
  for (Edge e : tracker.mesh().edges()) EXPECT_EQ(tracker.mesh().triangles(e).size(), 2u);
}

TEST(Topology, BubblesThatTouchAndPartAgainAreTwo) {
  SurfaceTracker tracker = tracker_of(test::two_spheres(2, 0.03, Region(1), Region(2)), SeparationRule::area);
  run(tracker, 2, [](const Vec3&) -> Vec3 { return Vec3::Zero(); });
  run(tracker, 12, [](const Vec3& x) -> Vec3 { return -2 * squeeze(x); });
  EXPECT_TRUE(test::all_complete(tracker.mesh()));
}

// A long step presses as a short one does.
TEST(Topology, OneLongStepGivesTheWallOfManyShortOnes) {
  SurfaceTracker tracker = tracker_of(test::two_spheres(2, 0.2, Region(1), Region(2)), SeparationRule::flow);
  run(tracker, 1, [](const Vec3& x) -> Vec3 { return 15 * squeeze(x); });
  EXPECT_EQ(euler_characteristic(tracker.mesh()), 3);
  EXPECT_NEAR(test::film_area(tracker.mesh(), Region(1), Region(2)), std::numbers::pi * 0.36, 0.45);
}

class Pebble : public testing::TestWithParam<Vec3> {};

// A bubble that is too small goes, wherever it is: in the air, in a bubble, on a wall, on a Plateau border.
TEST_P(Pebble, VanishesWithoutATrace) {
  SurfaceMesh mesh = test::four_columns({Region(1), Region(2), Region(3), Region(4)});
  const double h = mean_edge_length(mesh);
  test::add_pebble(mesh, GetParam(), 0.1 * h, GetParam()[0] > 1 ? air : Region(1));
  const double area_without = total_area(test::four_columns({Region(1), Region(2), Region(3), Region(4)}));
  ASSERT_EQ(audit(mesh).text(), "clean");
  TrackerOptions options;
  options.resolution = h;
  options.topology.enabled = true;
  options.topology.separate = options.topology.snap = false;
  options.remeshing = false;
  SurfaceTracker tracker(std::move(mesh), options);
  const TopologyStatistics done = tracker.change_topology();
  EXPECT_EQ(done[TopologyOperation::region_collapse].done, 1u);
  ASSERT_EQ(done.events.size(), 1u);
  EXPECT_EQ(done.events[0].kind, TopologyOperation::region_collapse);
  EXPECT_EQ(done.events[0].regions.front(), Region(7));
  EXPECT_EQ(audit(tracker.mesh()).text(), "clean");
  EXPECT_NEAR(total_area(tracker.mesh()), area_without, 1e-12);
}
INSTANTIATE_TEST_SUITE_P(InAirAndInABubble, Pebble, testing::Values(Vec3(1.5, 0, 0.5), Vec3(0.5, 0.5, 0.5)));

// Two bubbles with a pocket of air in the wall between them: a tetrahedron as thick as given, 0.8 long and 0.3 wide.
SurfaceMesh wall_with_pocket(double thickness) {
  SurfaceMesh mesh;
  const double z = 0.5 * thickness;
  std::array<Vertex, 4> rim = {mesh.add_vertex({0.4, 0, z}), mesh.add_vertex({0, 0.15, -z}),
                               mesh.add_vertex({-0.4, 0, z}), mesh.add_vertex({0, -0.15, -z})};
  std::array<Vertex, 4> edge = {mesh.add_vertex({1, -1, 0}), mesh.add_vertex({1, 1, 0}), mesh.add_vertex({-1, 1, 0}),
                                mesh.add_vertex({-1, -1, 0})};
  const Vertex top = mesh.add_vertex({0, 0, 1}), bottom = mesh.add_vertex({0, 0, -1});
  const Region above(1), below(2);
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t j = (i + 1) % 4;
    mesh.add_triangle(rim[i], edge[j], rim[j], {below, above});
    mesh.add_triangle(rim[i], edge[i], edge[j], {below, above});
    mesh.add_triangle(edge[i], edge[j], top, {above, air});
    mesh.add_triangle(edge[i], edge[j], bottom, {air, below});
  }
  mesh.add_triangle(rim[0], rim[1], rim[2], {air, above});
  mesh.add_triangle(rim[0], rim[2], rim[3], {air, above});
  mesh.add_triangle(rim[0], rim[1], rim[3], {below, air});
  mesh.add_triangle(rim[1], rim[2], rim[3], {below, air});
  return mesh;
}

std::size_t air_pockets_after_a_look(double thickness) {
  SurfaceMesh mesh = wall_with_pocket(thickness);
  const std::vector<RegionVolume> before = region_volumes(mesh);
  EXPECT_EQ(region_shape(mesh, air).pockets, 1u);
  TrackerOptions options;
  options.resolution = 1;
  options.topology.enabled = true;
  options.topology.separate = options.topology.snap = false;
  options.remeshing = false;
  SurfaceTracker tracker(std::move(mesh), options);
  tracker.change_topology();
  EXPECT_EQ(audit(tracker.mesh()).text(), "clean");
  const std::vector<RegionVolume> after = region_volumes(tracker.mesh());
  for (std::size_t i = 0; i < before.size(); ++i) EXPECT_NEAR(after.at(i).volume, before[i].volume, thickness);
  return region_shape(tracker.mesh(), air).pockets;
}

// Too long for a region that fits into a small box, but thinner than films that are joined when they are so near.
TEST(Topology, AFlatPocketBetweenTwoBubblesCloses) {
  EXPECT_EQ(air_pockets_after_a_look(1e-4), 0u);
  EXPECT_EQ(air_pockets_after_a_look(0.05), 0u);
  EXPECT_EQ(air_pockets_after_a_look(0.5), 1u);
}

// One cell of a foam, shrunk: its neighbours close the place.
TEST(Topology, ACellOfAFoamVanishes) {
  SurfaceMesh mesh = voronoi_foam({.cells = 12, .seed = 3, .subdivisions = 1});
  const Region cell(5);
  Vec3 centre = Vec3::Zero();
  std::vector<Vertex> corners;
  for (Vertex v : mesh.vertices())
    for (Triangle t : mesh.triangles(v))
      if (mesh.labels(t).has(cell)) {
        corners.push_back(v);
        break;
      }
  for (Vertex v : corners) centre += mesh.position(v) / static_cast<double>(corners.size());
  SurfaceTracker tracker = tracker_of(std::move(mesh), SeparationRule::area);
  const std::size_t before = regions(tracker.mesh()).size();
  TopologyStatistics sum;
  for (int step = 0; step < 60 && regions(tracker.mesh()).size() == before; ++step) {
    std::vector<Vec3> predicted(tracker.mesh().positions().begin(), tracker.mesh().positions().end());
    for (Triangle t : tracker.mesh().triangles())
      if (tracker.mesh().labels(t).has(cell))
        for (Vertex v : tracker.mesh().vertices(t)) {
          const Vec3& x = tracker.mesh().position(v);
          const Vec3 inwards = centre - x;
          predicted[v.index()] = x + std::min(0.1, 0.02 / inwards.norm()) * inwards;
        }
    sum += tracker.step(predicted).topology;
    ASSERT_EQ(audit(tracker.mesh()).text(), "clean") << "step " << step;
  }
  EXPECT_EQ(regions(tracker.mesh()).size(), before - 1);
  EXPECT_EQ(test::film_area(tracker.mesh(), cell, cell), 0);
}

// A foam with one edge of a tenth of the resolution, which is not below half the merge distance.
TEST(Topology, EdgesShorterThanMergeEdgeAreMerged) {
  for (const double merge_edge : {0.0, 0.2}) {
    SurfaceMesh mesh = voronoi_foam({.cells = 12, .seed = 3, .subdivisions = 1});
    const double resolution = mean_edge_length(mesh);
    const auto edges = mesh.edges();
    const Edge shortest = *std::ranges::min_element(edges, {}, [&](Edge e) { return length(mesh, e); });
    const auto [a, b] = mesh.vertices(shortest);
    mesh.set_position(a, mesh.position(b) + 0.1 * resolution * (mesh.position(a) - mesh.position(b)).normalized());
    TrackerOptions options;
    options.resolution = resolution;
    options.remeshing = false;
    options.topology.enabled = true;
    options.topology.pull_apart = 0.3;
    options.topology.merge_edge = merge_edge;
    SurfaceTracker tracker(std::move(mesh), options);
    const TopologyStatistics sum = run(tracker, 1, [](const Vec3&) { return Vec3(Vec3::Zero()); });
    EXPECT_EQ(sum[TopologyOperation::edge_merge].done > 0, merge_edge > 0);
    double least = resolution;
    for (Edge e : tracker.mesh().edges()) least = std::min(least, length(tracker.mesh(), e) / resolution);
    EXPECT_EQ(least < 0.1 + 1e-9, merge_edge == 0) << least;
    EXPECT_EQ(regions(tracker.mesh()).size(), 13u);
  }
}

TEST(Topology, TheResultDoesNotDependOnLabelsBeingLarge) {
  SurfaceTracker small = tracker_of(test::two_spheres(2, 0.2, Region(1), Region(2)), SeparationRule::flow);
  SurfaceTracker large = tracker_of(test::two_spheres(2, 0.2, Region(5001), Region(5002)), SeparationRule::flow);
  run(small, 8, squeeze);
  run(large, 8, squeeze);
  ASSERT_EQ(small.mesh().vertex_count(), large.mesh().vertex_count());
  for (Vertex v : small.mesh().vertices()) EXPECT_EQ(small.mesh().position(v), large.mesh().position(v));
}

}  // namespace
}  // namespace lostopos
