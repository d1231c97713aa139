#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "LosTopos/mesh/audit.h"
#include "LosTopos/mesh/box_walls.h"
#include "LosTopos/mesh/measures.h"
#include "LosTopos/shapes/solids.h"
#include "LosTopos/shapes/voronoi_foam.h"
#include "LosTopos/surface_tracker.h"

namespace lostopos {
namespace {

TEST(Hold, BitsAddUpAndAreSharedInOneWallOnly) {
  EXPECT_TRUE(is_held(Hold::all));
  EXPECT_TRUE(is_held(Hold::x | Hold::y | Hold::z));
  EXPECT_FALSE(is_held(Hold::x | Hold::z));
  EXPECT_TRUE(holds_all_of(Hold::all, Hold::x | Hold::y));
  EXPECT_FALSE(holds_all_of(Hold::x, Hold::x | Hold::y));
  EXPECT_EQ(Hold::x | Hold::y | Hold::z, Hold::all);
  EXPECT_EQ(Hold::x | Hold::all, Hold::all);
  EXPECT_EQ(free_part(Hold::x | Hold::z, Vec3(1, 2, 3)), Vec3(0, 2, 0));
  EXPECT_EQ(free_part(Hold::all, Vec3(1, 2, 3)), Vec3::Zero());
  const Vec3 left(0, 0.2, 1), right(1, 0.7, 1);
  EXPECT_EQ(common_hold(Hold::x | Hold::z, left, Hold::x | Hold::z, right), Hold::z);
  EXPECT_EQ(common_hold(Hold::all, left, Hold::z, right), Hold::z);
  EXPECT_EQ(common_hold(Hold::x, left, Hold::z, right), Hold::none);
}

Hold hold_by_position(const Vec3& x) {
  Hold hold = Hold::none;
  for (int i = 0; i < 3; ++i)
    if (x[i] == 0 || x[i] == 1) hold |= hold_of_coordinate(i);
  return hold;
}

SurfaceTracker foam_in_a_box(TrackerOptions options) {
  SurfaceMesh foam = voronoi_foam({.cells = 6, .seed = 2, .subdivisions = 2});
  options.resolution = mean_edge_length(foam);
  SurfaceTracker tracker(std::move(foam), options);
  hold_in_box_walls(tracker.mesh(), tracker.held(), Vec3::Zero(), Vec3::Ones());
  return tracker;
}

// Walls, creases and corners are where they were: whoever is on one is held there, and the box is full.
void expect_walls_kept(SurfaceTracker& tracker) {
  const SurfaceMesh& mesh = tracker.mesh();
  std::size_t corners = 0;
  for (Vertex v : mesh.vertices()) {
    ASSERT_EQ(tracker.held()[v], hold_by_position(mesh.position(v))) << "vertex " << v.index();
    corners += is_held(tracker.held()[v]);
  }
  EXPECT_EQ(corners, 8u);
  EXPECT_NEAR(region_volumes(mesh)[0].volume, -1, 1e-12);
  EXPECT_EQ(audit(mesh).text(), "clean");
}

// A shear that every wall may slide along.
Vec3 swirl(const Vec3& x, double size) {
  constexpr double pi = std::numbers::pi;
  const Vec3 s = (pi * x).array().sin(), c = (pi * x).array().cos();
  return size * Vec3(s.x() * c.y(), -c.x() * s.y() * (1 + x.z()), s.z() * c.y());
}

TEST(SlidingWalls, StayThroughRemeshingThatChangesThem) {
  SurfaceTracker tracker = foam_in_a_box({});
  RemeshStatistics done;
  for (int step = 0; step < 25; ++step) {
    std::vector<Vec3> predicted(tracker.mesh().positions().begin(), tracker.mesh().positions().end());
    for (Vertex v : tracker.mesh().vertices())
      predicted[v.index()] += free_part(tracker.held()[v], swirl(tracker.mesh().position(v), 0.02));
    tracker.advance(predicted);
    done += tracker.remesh();
  }
  expect_walls_kept(tracker);
  EXPECT_GT(done[Operation::split].done, 50u);
  EXPECT_GT(done[Operation::collapse].done, 50u);
  EXPECT_GT(done[Operation::flip].done, 50u);
  EXPECT_GT(done[Operation::smoothing].done, 50u);
}

// Coarser by half: nearly every edge of the walls and creases has to go, or is refused.
TEST(SlidingWalls, StayThroughCoarsening) {
  SurfaceMesh foam = voronoi_foam({.cells = 6, .seed = 2, .subdivisions = 3});
  TrackerOptions options;
  options.resolution = 2.5 * mean_edge_length(foam);
  SurfaceTracker tracker(std::move(foam), options);
  hold_in_box_walls(tracker.mesh(), tracker.held(), Vec3::Zero(), Vec3::Ones());
  const std::size_t before = tracker.mesh().triangle_count();
  for (int i = 0; i < 3; ++i) tracker.remesh();
  EXPECT_LT(tracker.mesh().triangle_count(), before / 3);
  expect_walls_kept(tracker);
}

// Everything inside is driven into one wall, much farther than there is room.
TEST(SlidingWalls, StayWhenTheInsideIsPressedAgainstThem) {
  SurfaceTracker tracker = foam_in_a_box({.remeshing = false});
  std::size_t collisions = 0;
  for (int step = 0; step < 6; ++step) {
    std::vector<Vec3> predicted(tracker.mesh().positions().begin(), tracker.mesh().positions().end());
    for (Vertex v : tracker.mesh().vertices())
      predicted[v.index()] += free_part(tracker.held()[v], Vec3(0.03, 0.02, -0.15));
    collisions += tracker.advance(predicted).statistics.collisions;
  }
  EXPECT_GT(collisions, 0u);
  expect_walls_kept(tracker);
}

// A tetrahedron dives at a wall's triangle whose vertices slide: they are pushed along the wall at most.
TEST(SlidingWalls, ABodyThatHitsOneIsStopped) {
  SurfaceMesh mesh = cube(3);
  const double wall = mesh.position(Vertex(0)).z();  // its lower one
  const std::size_t first = mesh.vertex_slots();
  for (const Vec3& x : {Vec3(0.05, 0.03, -0.5), Vec3(0.2, 0, -0.3), Vec3(-0.1, 0.15, -0.3), Vec3(-0.1, -0.15, -0.3)})
    mesh.add_vertex(x);
  const Vertex a(first), b(first + 1), c(first + 2), d(first + 3);
  const Labels labels{Region(2), Region(1)};
  mesh.add_triangle(a, c, b, labels);
  mesh.add_triangle(a, d, c, labels);
  mesh.add_triangle(a, b, d, labels);
  mesh.add_triangle(b, c, d, labels);
  TrackerOptions options{.resolution = 0.2, .remeshing = false};
  SurfaceTracker tracker(std::move(mesh), options);
  hold_in_box_walls(tracker.mesh(), tracker.held(), Vec3::Constant(wall), Vec3::Constant(-wall));
  std::vector<Vec3> predicted(tracker.mesh().positions().begin(), tracker.mesh().positions().end());
  for (Vertex v : {a, b, c, d}) predicted[v.index()].z() -= 0.4;
  const MoveResult moved = tracker.advance(predicted);
  EXPECT_GT(moved.statistics.collisions, 0u);
  EXPECT_EQ(moved.fraction, 1);
  for (std::size_t i = 0; i < first; ++i) {
    const Vec3 &asked = predicted[i], &is = tracker.mesh().position(Vertex(i));
    for (int k = 0; k < 3; ++k)
      EXPECT_TRUE(is[k] == asked[k] || !holds(tracker.held()[Vertex(i)], k)) << "vertex " << i;
  }
  EXPECT_GT(tracker.mesh().position(a).z(), wall);
  EXPECT_EQ(audit(tracker.mesh()).text(), "clean");
}

}  // namespace
}  // namespace lostopos
