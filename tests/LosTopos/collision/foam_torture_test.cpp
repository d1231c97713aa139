// A foam of 20 bubbles whose vertices are all sent in random directions, step after step, and which is remeshed after
// each.
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <random>

#include "LosTopos/mesh/audit.h"
#include "LosTopos/mesh/measures.h"
#include "LosTopos/shapes/voronoi_foam.h"
#include "LosTopos/surface_tracker.h"

namespace lostopos {
namespace {

// Evenly distributed in the ball of the given radius.
Vec3 random_in_ball(std::mt19937& random, double radius) {
  std::uniform_real_distribution<double> coordinate(-1, 1);
  Vec3 u;
  do {
    for (double& x : u) x = coordinate(random);
  } while (u.norm() > 1);
  return radius * u;
}

struct Totals {
  MoveStatistics moves;
  RemeshStatistics remeshing;
  double smallest_fraction = 1;
};

void print(const SurfaceMesh& mesh, const Totals& sum) {
  std::cout << mesh.triangle_count() << " triangles at the end; " << sum.moves.collisions << " collisions, "
            << sum.moves.impulses << " impulses, " << sum.moves.inelastic_zones << " inelastic and "
            << sum.moves.rigid_zones << " rigid zones (largest " << sum.moves.largest_zone << "), "
            << sum.moves.halvings << " halvings, smallest fraction " << sum.smallest_fraction << "\n"
            << sum.remeshing[Operation::split].done << " splits, " << sum.remeshing[Operation::collapse].done
            << " collapses, " << sum.remeshing[Operation::flip].done << " flips, "
            << sum.remeshing[Operation::smoothing].done << " smoothings; remeshing " << sum.remeshing.seconds << " s\n";
}

TEST(FoamTorture, RandomVelocitiesOnTwentyBubbles) {
  SurfaceMesh foam = voronoi_foam({.cells = 20, .subdivisions = 1});
  const double h = mean_edge_length(foam);
  const auto regions_at_start = regions(foam);
  SurfaceTracker tracker(std::move(foam), {.resolution = h});
  std::cout << tracker.mesh().triangle_count() << " triangles at the start\n";
  std::mt19937 random(11);
  Totals sum;
  for (int step = 0; step < FOAM_TORTURE_STEPS; ++step) {
    SCOPED_TRACE("step " + std::to_string(step));
    std::vector<Vec3> predicted(tracker.mesh().positions().begin(), tracker.mesh().positions().end());
    for (Vec3& x : predicted) x += random_in_ball(random, 0.3 * h);
    MoveResult moved;
    ASSERT_NO_THROW(moved = tracker.advance(predicted));
    sum.moves += moved.statistics;
    sum.smallest_fraction = std::min(sum.smallest_fraction, moved.fraction);
    ASSERT_EQ(audit(tracker.mesh()).text(), "clean") << "after the move";
    sum.remeshing += tracker.remesh();
    ASSERT_EQ(audit(tracker.mesh()).text(), "clean") << "after remeshing";
    ASSERT_EQ(regions(tracker.mesh()), regions_at_start);
  }
  print(tracker.mesh(), sum);
  EXPECT_GT(sum.moves.collisions, 0u);
  EXPECT_GT(sum.remeshing.done_in_all(), 0u);
  for (const RegionVolume& region : region_volumes(tracker.mesh())) {
    if (region.region != air) {
      EXPECT_GT(region.volume, 0) << "region " << region.region.index();
    }
  }
}

}  // namespace
}  // namespace lostopos
