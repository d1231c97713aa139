#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "FoamSim/scenes/shapes/double_bubble.h"
#include "LosTopos/mesh/measures.h"
#include "LosTopos/shapes/solids.h"
#include "tests/LosTopos/collision/move_checks.h"
#include "tests/support/sample_meshes.h"

// Motions that would tangle the surface if they were done as asked. The mesh is not remeshed in between, which makes
// them harder. After every step the whole mesh is audited, with exact intersection tests.

namespace lostopos {
namespace {

using test::add_part;
using test::add_sheet;
using test::move_and_check;
using test::positions_of;

MoveOptions options_for(const SurfaceMesh& mesh) {
  MoveOptions options;
  options.proximity_epsilon = 1e-4 * mean_edge_length(mesh);
  return options;
}

Vec3 mean(const SurfaceMesh& mesh, const std::vector<Vertex>& vertices) {
  Vec3 sum = Vec3::Zero();
  for (Vertex v : vertices) sum += mesh.position(v);
  return sum / static_cast<double>(vertices.size());
}

// Both keep being asked to fly on as if nothing were there.
TEST(MotionTorture, TwoSpheresShotThroughEachOther) {
  SurfaceMesh mesh;
  const SurfaceMesh ball = icosphere(3);
  const auto left = add_part(mesh, ball, Region(1), [](const Vec3& x) { return Vec3(x - Vec3(1.1, 0, 0)); });
  const auto right = add_part(mesh, ball, Region(2), [](const Vec3& x) { return Vec3(x + Vec3(1.1, 0.2, 0.1)); });
  const MoveOptions options = options_for(mesh);
  MoveStatistics sum;
  for (int step = 0; step < 30; ++step) {
    std::vector<Vec3> predicted = positions_of(mesh);
    for (Vertex v : left) predicted[v.index()].x() += 0.05;
    for (Vertex v : right) predicted[v.index()].x() -= 0.05;
    ASSERT_TRUE(move_and_check(mesh, predicted, {}, options, sum)) << "step " << step;
  }
  test::print("two spheres", sum);
  EXPECT_GT(sum.collisions, 0u);
  // What the response gives to one it takes from the other.
  if (sum.halvings == 0) {
    EXPECT_NEAR((mean(mesh, left) + mean(mesh, right) - Vec3(0, 0.2, 0.1)).norm(), 0, 1e-9);
  }
}

// In one step each is asked to go where the other is, and beyond.
TEST(MotionTorture, TwoSpheresShotThroughEachOtherInOneStep) {
  SurfaceMesh mesh;
  const SurfaceMesh ball = icosphere(2);
  const auto left = add_part(mesh, ball, Region(1), [](const Vec3& x) { return Vec3(x - Vec3(1.5, 0, 0)); });
  const auto right = add_part(mesh, ball, Region(2), [](const Vec3& x) { return Vec3(x + Vec3(1.5, 0, 0)); });
  const MoveOptions options = options_for(mesh);
  MoveStatistics sum;
  for (int step = 0; step < 3; ++step) {
    std::vector<Vec3> predicted = positions_of(mesh);
    for (Vertex v : left) predicted[v.index()].x() += 4;
    for (Vertex v : right) predicted[v.index()].x() -= 4;
    ASSERT_TRUE(move_and_check(mesh, predicted, {}, options, sum)) << "step " << step;
  }
  test::print("two fast spheres", sum);
  EXPECT_LT(mean(mesh, left).x(), mean(mesh, right).x()) << "they have not passed";
}

// A plate of held vertices comes down on a sphere that is asked to stay.
TEST(MotionTorture, SpherePressedByAPlaneOfHeldVertices) {
  SurfaceMesh mesh;
  add_part(mesh, icosphere(3), Region(1), [](const Vec3& x) { return x; });
  const MoveOptions options = options_for(mesh);
  const auto plate = add_sheet(mesh, 2, Vec3(-2, -2, 1.05), Vec3(4, 0, 0), Vec3(0, 4, 0), {air, Region(2)});
  std::vector<Hold> held(mesh.vertex_slots(), Hold::none);
  for (Vertex v : plate) held[v.index()] = Hold::all;
  MoveStatistics sum;
  for (int step = 0; step < 50; ++step) {
    std::vector<Vec3> predicted = positions_of(mesh);
    for (Vertex v : plate) predicted[v.index()].z() -= 0.05;
    ASSERT_TRUE(move_and_check(mesh, predicted, held, options, sum, false)) << "step " << step;
  }
  test::print("pressed sphere", sum);
  EXPECT_LT(mean(mesh, plate).z(), -1.2) << "it has swept over all of the sphere";
  for (Vertex v : mesh.vertices()) {
    if (!is_held(held[v.index()])) {
      EXPECT_LT(mesh.position(v).z(), mean(mesh, plate).z());
    }
  }
}

// The outer half of a flat film turns about the middle line and is asked to go right through the other half.
TEST(MotionTorture, FilmFoldedOntoItself) {
  SurfaceMesh mesh;
  const auto film = add_sheet(mesh, 16, Vec3(-1, -1, 0), Vec3(2, 0, 0), Vec3(0, 2, 0), {air, Region(1)});
  const MoveOptions options = options_for(mesh);
  const double turn = 0.09;
  MoveStatistics sum;
  for (int step = 0; step < 50; ++step) {
    std::vector<Vec3> predicted = positions_of(mesh);
    for (Vertex v : film) {
      const Vec3& x = mesh.position(v);
      if (static_cast<long>(v.index()) % 17 <= 8) continue;
      predicted[v.index()] = {std::cos(turn) * x.x() - std::sin(turn) * x.z(), x.y(),
                              std::sin(turn) * x.x() + std::cos(turn) * x.z()};
    }
    ASSERT_TRUE(move_and_check(mesh, predicted, {}, options, sum, false)) << "step " << step;
  }
  test::print("folded film", sum);
  EXPECT_GT(sum.collisions, 0u);
}

// The waist of a bubble is asked to become thinner than nothing while its ends are pulled apart.
TEST(MotionTorture, ThinNeckPulled) {
  SurfaceMesh mesh = test::globe(1, 24);
  for (Vertex v : mesh.vertices()) {
    const Vec3 x = mesh.position(v);
    const double waist = 0.1 + 0.9 * std::min(1.0, x.x() * x.x() * 4);
    mesh.set_position(v, Vec3(2 * x.x(), waist * x.y(), waist * x.z()));
  }
  const MoveOptions options = options_for(mesh);
  MoveStatistics sum;
  for (int step = 0; step < 30; ++step) {
    std::vector<Vec3> predicted = positions_of(mesh);
    for (Vec3& x : predicted) {
      const double towards_axis = -0.02 * std::exp(-4 * x.x() * x.x());
      const double radius = std::hypot(x.y(), x.z());
      if (radius > 0) x += towards_axis / radius * Vec3(0, x.y(), x.z());
      x.x() *= 1.01;
    }
    ASSERT_TRUE(move_and_check(mesh, predicted, {}, options, sum)) << "step " << step;
  }
  test::print("thin neck", sum);
  EXPECT_GT(sum.collisions, 0u);
}

// Sheets 1e-8 apart that are asked to go through each other, at any scale and far from the origin.
void press_thin_gaps(double unit, const Vec3& origin) {
  SurfaceMesh mesh;
  std::vector<std::vector<Vertex>> sheets;
  for (int k = 0; k < 4; ++k) {
    const double shift = 0.03 * k;
    const Vec3 corner = origin + unit * Vec3(-1 + shift, -1 - shift, 1e-8 * k);
    sheets.push_back(add_sheet(mesh, 6, corner, unit * Vec3(2, 0, 0), unit * Vec3(0, 2, 0),
                               {Region(static_cast<std::size_t>(k)), Region(static_cast<std::size_t>(k) + 1)}));
  }
  const MoveOptions options = options_for(mesh);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> velocity(-0.02, 0.02);
  MoveStatistics sum;
  for (int step = 0; step < 20; ++step) {
    std::vector<Vec3> predicted = positions_of(mesh);
    for (int k = 0; k < 4; ++k) {
      for (Vertex v : sheets[static_cast<std::size_t>(k)]) {
        predicted[v.index()] += unit * Vec3(velocity(random), velocity(random), 0.02 * (1.5 - k) + velocity(random));
      }
    }
    ASSERT_TRUE(move_and_check(mesh, predicted, {}, options, sum, false)) << "step " << step;
  }
  test::print("thin gaps", sum);
  EXPECT_GT(sum.collisions, 0u);
}

TEST(MotionTorture, ThinGaps) {
  press_thin_gaps(1, Vec3::Zero());
}

TEST(MotionTorture, ThinGapsInTinyUnits) {
  press_thin_gaps(1e-9, Vec3::Zero());
}

TEST(MotionTorture, ThinGapsFarFromTheOrigin) {
  press_thin_gaps(1, Vec3(1000, -2000, 500));
}

TEST(MotionTorture, RandomVelocitiesOnADoubleBubble) {
  SurfaceMesh mesh = foamsim::double_bubble(16);
  const double h = mean_edge_length(mesh);
  const MoveOptions options = options_for(mesh);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> velocity(-1, 1);
  MoveStatistics sum;
  for (int step = 0; step < 100; ++step) {
    std::vector<Vec3> predicted = positions_of(mesh);
    for (Vec3& x : predicted) {
      Vec3 u;
      do {
        u = Vec3(velocity(random), velocity(random), velocity(random));
      } while (u.norm() > 1);
      x += 0.3 * h * u;
    }
    ASSERT_TRUE(move_and_check(mesh, predicted, {}, options, sum)) << "step " << step;
  }
  test::print("random velocities", sum);
  EXPECT_GT(sum.collisions, 0u);
}

}  // namespace
}  // namespace lostopos
