#include "LosTopos/collision/safe_move.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <limits>
#include <random>

#include "FoamSim/scenes/shapes/double_bubble.h"
#include "LosTopos/mesh/measures.h"
#include "tests/LosTopos/collision/move_checks.h"
#include "tests/support/sample_meshes.h"

namespace lostopos {
namespace {

using test::add_sheet;
using test::corner_tetrahedron;
using test::positions_of;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(SafeMove, QuietMotionArrivesToTheBit) {
  SurfaceMesh mesh = foamsim::double_bubble(16);
  std::vector<Vec3> predicted = positions_of(mesh);
  for (Vec3& x : predicted) x += 0.01 * Vec3(std::sin(x.y()), std::cos(x.z()), x.x());
  MoveOptions options;
  options.proximity_epsilon = 1e-4 * mean_edge_length(mesh);
  const MoveResult result = move_safely(mesh, predicted, {}, options);
  EXPECT_EQ(positions_of(mesh), predicted);
  EXPECT_EQ(result.fraction, 1);
  EXPECT_EQ(result.statistics.collisions, 0u);
  EXPECT_EQ(result.statistics.proximities, 0u);
  EXPECT_GT(result.statistics.pairs, 0u);
}

TEST(SafeMove, RefusesPredictionsThatAreNotFinite) {
  for (double bad : {nan, std::numeric_limits<double>::infinity()}) {
    SurfaceMesh mesh = corner_tetrahedron();
    const std::vector<Vec3> before = positions_of(mesh);
    std::vector<Vec3> predicted = before;
    predicted[0] += Vec3::Ones();
    predicted[2].y() = bad;
    EXPECT_THROW(move_safely(mesh, predicted, {}, {}), MotionError);
    EXPECT_EQ(positions_of(mesh), before);
  }
}

TEST(SafeMove, DoesNotReadDeadSlots) {
  SurfaceMesh mesh = corner_tetrahedron();
  const Vertex dead = mesh.add_vertex(Vec3::Zero());
  mesh.remove_vertex(dead);
  std::vector<Vec3> predicted = positions_of(mesh);
  for (Vec3& x : predicted) x += Vec3::Ones();
  predicted[dead.index()].setConstant(nan);
  EXPECT_EQ(move_safely(mesh, predicted, {}, {}).fraction, 1);
  EXPECT_EQ(mesh.position(Vertex(1)), predicted[1]);
}

TEST(SafeMove, RefusesWrongSizesAndOptions) {
  SurfaceMesh mesh = corner_tetrahedron();
  const std::vector<Vec3> predicted = positions_of(mesh);
  const std::vector<Hold> held(3, Hold::none);
  EXPECT_THROW(move_safely(mesh, std::span(predicted).first(3), {}, {}), base::InputError);
  EXPECT_THROW(move_safely(mesh, predicted, held, {}), base::InputError);
  MoveOptions options;
  options.proximity_epsilon = -1;
  EXPECT_THROW(move_safely(mesh, predicted, {}, options), base::InputError);
  options = {};
  options.smallest_step = 0;
  EXPECT_THROW(move_safely(mesh, predicted, {}, options), base::InputError);
}

// A tetrahedron with its tip `gap` above the middle of a film, both far larger than the gap.
struct TipAboveFilm {
  explicit TipAboveFilm(double gap) {
    tip = mesh.add_vertex({0, 0, gap});
    const Vertex a = mesh.add_vertex({1, 0, 3}), b = mesh.add_vertex({-1, 1, 3}), c = mesh.add_vertex({-1, -1, 3});
    const Labels labels = {Region(1), air};
    mesh.add_triangle(a, b, c, labels);
    mesh.add_triangle(tip, b, a, labels);
    mesh.add_triangle(tip, c, b, labels);
    mesh.add_triangle(tip, a, c, labels);
    for (const Vec3& x : {Vec3(4, 0, 0), Vec3(-2, 3, 0), Vec3(-2, -3, 0)}) film.push_back(mesh.add_vertex(x));
    mesh.add_triangle(film[0], film[1], film[2], {Region(2), air});
  }
  double gap() const { return mesh.position(tip).z() - mesh.position(film[0]).z(); }
  SurfaceMesh mesh;
  Vertex tip;
  std::vector<Vertex> film;
};

TEST(SafeMove, NearElementsArePushedApartByATenthOfWhatTheyLack) {
  TipAboveFilm scene(0.004);
  MoveOptions options;
  options.proximity_epsilon = 0.01;
  const MoveResult result = move_safely(scene.mesh, positions_of(scene.mesh), {}, options);
  EXPECT_EQ(result.statistics.proximities, 1u);
  EXPECT_EQ(result.statistics.impulses, 1u);
  EXPECT_NEAR(scene.gap(), 0.004 + 0.1 * 0.006, 1e-15);
}

TEST(SafeMove, CollidingElementsKeepTheirMomentum) {
  TipAboveFilm scene(0.5);
  std::vector<Vec3> predicted = positions_of(scene.mesh);
  for (std::size_t i = 0; i < 4; ++i) predicted[i].z() -= 1.2;
  Vec3 expected = Vec3::Zero(), sum = Vec3::Zero();
  for (const Vec3& x : predicted) expected += x;
  const MoveResult result = move_safely(scene.mesh, predicted, {}, {});
  EXPECT_EQ(result.fraction, 1);
  EXPECT_GT(result.statistics.impulses, 0u);
  for (const Vec3& x : scene.mesh.positions()) sum += x;
  EXPECT_NEAR((sum - expected).norm(), 0, 1e-14);
  EXPECT_NEAR(scene.gap(), 0.25, 1e-14) << "half of the gap closes, no more";
}

TEST(SafeMove, FreeElementsGiveWayToHeldOnes) {
  TipAboveFilm scene(0.5);
  std::vector<Vec3> predicted = positions_of(scene.mesh);
  std::vector<Hold> held(scene.mesh.vertex_slots(), Hold::none);
  for (Vertex v : scene.film) {
    predicted[v.index()].z() += 0.7;
    held[v.index()] = Hold::all;
  }
  EXPECT_EQ(move_safely(scene.mesh, predicted, held, {}).fraction, 1);
  for (Vertex v : scene.film) EXPECT_EQ(scene.mesh.position(v), predicted[v.index()]);
  EXPECT_NEAR(scene.gap(), 0.25, 1e-14);
}

// What is sent into each other again and again comes as close as one likes, and never touches.
TEST(SafeMove, PressedElementsComeCloserStepByStep) {
  TipAboveFilm scene(0.5);
  for (int step = 0; step < 8; ++step) {
    std::vector<Vec3> predicted = positions_of(scene.mesh);
    const double before = scene.gap();
    for (std::size_t i = 0; i < 4; ++i) predicted[i].z() -= 1.2 * before;
    EXPECT_EQ(move_safely(scene.mesh, predicted, {}, {}).fraction, 1);
    EXPECT_NEAR(scene.gap(), before / 2, 1e-12);
  }
}

// Held plates, with or without a film between them, that are asked to go through each other.
struct Plates {
  explicit Plates(bool with_film) {
    low = add_sheet(mesh, 2, Vec3(-1, -1, -1), Vec3(2, 0, 0), Vec3(0, 2, 0), {air, Region(1)});
    high = add_sheet(mesh, 2, Vec3(-1, -1.1, 1), Vec3(2, 0, 0), Vec3(0, 2, 0), {Region(1), air});
    if (with_film) add_sheet(mesh, 5, Vec3(-0.9, -0.9, 0), Vec3(1.7, 0, 0), Vec3(0, 1.7, 0), {Region(1), Region(2)});
    held.assign(mesh.vertex_slots(), Hold::none);
    for (const auto* plate : {&low, &high}) {
      for (Vertex v : *plate) held[v.index()] = Hold::all;
    }
  }
  std::vector<Vec3> closer_by(double distance) const {
    std::vector<Vec3> predicted = positions_of(mesh);
    for (Vertex v : low) predicted[v.index()].z() += distance;
    for (Vertex v : high) predicted[v.index()].z() -= distance;
    return predicted;
  }
  SurfaceMesh mesh;
  std::vector<Vertex> low, high;
  std::vector<Hold> held;
};

TEST(SafeMove, HalvesTheStepWhenTheWholeCannotBeDone) {
  Plates plates(false);
  const std::vector<Vec3> predicted = plates.closer_by(1.5);
  const MoveResult result = move_safely(plates.mesh, predicted, plates.held, {});
  EXPECT_EQ(result.fraction, 0.5);
  EXPECT_EQ(result.statistics.halvings, 1u);
  for (Vertex v : plates.low) EXPECT_EQ(plates.mesh.position(v).z(), -0.25);
  for (Vertex v : plates.high) EXPECT_EQ(plates.mesh.position(v).z(), 0.25);
}

TEST(SafeMove, SaysWhatCannotBeDoneAndLeavesTheMesh) {
  Plates plates(true);
  const std::vector<Vec3> before = positions_of(plates.mesh);
  try {
    move_safely(plates.mesh, plates.closer_by(1000), plates.held, {});
    FAIL() << "plates have gone through each other";
  } catch (const CollisionFailure& failure) {
    EXPECT_FALSE(failure.contacts().empty());
    const std::string message = failure.what();
    EXPECT_NE(message.find("0.015625"), std::string::npos) << message;
    EXPECT_TRUE(message.find("vertex ") != std::string::npos || message.find("edge ") != std::string::npos) << message;
  }
  EXPECT_EQ(positions_of(plates.mesh), before);
}

TEST(SafeMove, FilmBetweenClosingPlatesIsKeptBetweenThem) {
  Plates plates(true);
  MoveOptions options;
  options.proximity_epsilon = 1e-4;
  MoveStatistics sum;
  for (int step = 0; step < 9; ++step) {
    ASSERT_TRUE(test::move_and_check(plates.mesh, plates.closer_by(0.11), plates.held, options, sum, false));
  }
  const double low = plates.mesh.position(plates.low[0]).z(), high = plates.mesh.position(plates.high[0]).z();
  EXPECT_NEAR(high - low, 0.02, 1e-12);
  for (Vertex v : plates.mesh.vertices()) {
    if (is_held(plates.held[v.index()])) continue;
    EXPECT_GT(plates.mesh.position(v).z(), low);
    EXPECT_LT(plates.mesh.position(v).z(), high);
  }
}

// Sixty large triangles, and beside them, within the boxes of their edges, two thousand small ones.
SurfaceMesh triangles_of_two_sizes() {
  SurfaceMesh mesh;
  const auto add = [&mesh](const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vertex first = mesh.add_vertex(a), second = mesh.add_vertex(b), third = mesh.add_vertex(c);
    mesh.add_triangle(first, second, third, {Region(1), air});
  };
  for (int i = 0; i < 60; ++i) {
    const Vec3 up(0, 0, 1e-3 * i);
    add(up, Vec3(1, 1, 1) + up, Vec3(1, 0, 0.5) + up);
  }
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(0.2, 0.8);
  for (int i = 0; i < 2000; ++i) {
    const double x = place(random) / 2;
    const Vec3 at(x, x + 0.1 + 0.4 * place(random), place(random));
    add(at, at + Vec3(1e-4, 0, 0), at + Vec3(0, 1e-4, 0));
  }
  return mesh;
}

TEST(SafeMove, SaysThatTheSizesOfTrianglesAreTooDifferent) {
  SurfaceMesh mesh = triangles_of_two_sizes();
  std::vector<Vec3> predicted = positions_of(mesh);
  for (Vec3& x : predicted) x.z() += 1e-6;
  try {
    move_safely(mesh, predicted, {}, {});
    ADD_FAILURE() << "it moved";
  } catch (const CollisionFailure& failure) {
    const std::string message = failure.what();
    EXPECT_NE(message.find("sizes of its triangles are too different"), std::string::npos) << message;
    EXPECT_EQ(message.find(" 0 pair"), std::string::npos) << message;
  }
}

struct Outcome {
  std::vector<Vec3> positions;
  MoveStatistics sum;
};

// A double bubble that is crumpled: every stage has work to do.
Outcome crumple(std::size_t threads) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  SurfaceMesh mesh = foamsim::double_bubble(16);
  const double h = mean_edge_length(mesh);
  MoveOptions options;
  options.proximity_epsilon = 1e-2 * h;
  options.impulse_passes = 2;
  options.zone_passes = 2;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> velocity(-h, h);
  Outcome outcome;
  for (int step = 0; step < 10; ++step) {
    std::vector<Vec3> predicted = positions_of(mesh);
    for (Vec3& x : predicted) x = 0.9 * x + Vec3(velocity(random), velocity(random), velocity(random));
    outcome.sum += move_safely(mesh, predicted, {}, options).statistics;
  }
  outcome.positions = positions_of(mesh);
  return outcome;
}

TEST(SafeMove, SameBitsForOneAndTwoThreads) {
  const Outcome one = crumple(1), two = crumple(2);
  EXPECT_EQ(one.positions, two.positions);
  EXPECT_EQ(one.sum.collisions, two.sum.collisions);
  EXPECT_EQ(one.sum.impulses, two.sum.impulses);
  test::print("crumpled", one.sum);
  EXPECT_GT(one.sum.proximities, 0u);
  EXPECT_GT(one.sum.inelastic_zones, 0u);
  EXPECT_GT(one.sum.rigid_zones, 0u);
}

}  // namespace
}  // namespace lostopos
