#include "LosTopos/collision/contact_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "FoamSim/scenes/shapes/double_bubble.h"
#include "LosTopos/geometry/ccd.h"
#include "LosTopos/geometry/distance.h"
#include "LosTopos/mesh/measures.h"
#include "tests/LosTopos/collision/move_checks.h"

namespace lostopos {
namespace {

using Pairs = std::vector<ElementPair>;

std::vector<ElementPair> all_pairs(const SurfaceMesh& mesh) {
  Pairs pairs;
  for (Vertex v : mesh.vertices()) {
    for (Triangle t : mesh.triangles()) {
      const auto& [a, b, c] = mesh.vertices(t);
      if (v == a || v == b || v == c) continue;
      pairs.push_back({ElementPair::Kind::vertex_triangle, v.index(), t.index(), {v, a, b, c}});
    }
  }
  for (Edge e : mesh.edges()) {
    for (Edge f : mesh.edges()) {
      const auto& [a, b] = mesh.vertices(e);
      const auto& [c, d] = mesh.vertices(f);
      if (!(e < f) || a == c || a == d || b == c || b == d) continue;
      pairs.push_back({ElementPair::Kind::edge_edge, e.index(), f.index(), {a, b, c, d}});
    }
  }
  return pairs;
}

bool collides(const Motion& motion, const ElementPair& pair) {
  std::array<Trajectory, 4> x;
  for (std::size_t i = 0; i < 4; ++i) {
    x[i] = {motion.starts()[pair.vertices[i].index()], motion.ends()[pair.vertices[i].index()]};
  }
  return pair.kind == ElementPair::Kind::vertex_triangle ? vertex_triangle_collision(x[0], x[1], x[2], x[3]).has_value()
                                                         : edge_edge_collision(x[0], x[1], x[2], x[3]).has_value();
}

double start_distance(const Motion& motion, const ElementPair& pair) {
  const auto at = [&](std::size_t i) { return motion.starts()[pair.vertices[i].index()]; };
  return pair.kind == ElementPair::Kind::vertex_triangle
             ? point_triangle_distance(at(0), at(1), at(2), at(3)).distance
             : segment_segment_distance(at(0), at(1), at(2), at(3)).distance;
}

Pairs pairs_of(const std::vector<Contact>& contacts) {
  Pairs pairs;
  for (const Contact& contact : contacts) pairs.push_back(contact.pair);
  return pairs;
}

Vec3 random_vector(std::mt19937& random, double size) {
  std::uniform_real_distribution<double> component(-size, size);
  return {component(random), component(random), component(random)};
}

struct Scene {
  explicit Scene(double speed, unsigned seed) : mesh(foamsim::double_bubble(8)), random(seed) {
    predicted = test::positions_of(mesh);
    for (Vec3& x : predicted) x += random_vector(random, speed * mean_edge_length(mesh));
  }
  SurfaceMesh mesh;
  std::mt19937 random;
  std::vector<Vec3> predicted;
};

TEST(ContactSearch, FindsWhatBruteForceFinds) {
  for (unsigned seed = 0; seed < 4; ++seed) {
    const double speed = 0.5 * (seed + 1);
    Scene scene(speed, seed);
    Motion motion(scene.mesh, scene.predicted, {});
    MoveStatistics statistics;
    Pairs expected;
    for (const ElementPair& pair : all_pairs(scene.mesh)) {
      if (collides(motion, pair)) expected.push_back(pair);
    }
    std::ranges::sort(expected);
    EXPECT_EQ(pairs_of(ContactSearch(scene.mesh, motion, 0, statistics).all().collisions), expected);
    EXPECT_GT(expected.size(), 0u);
    EXPECT_EQ(statistics.collisions, expected.size());
  }
}

TEST(ContactSearch, FindsAllProximities) {
  Scene scene(0, 1);
  // Wide enough that many pairs are nearer.
  const double epsilon = 0.8 * mean_edge_length(scene.mesh);
  Motion motion(scene.mesh, scene.predicted, {});
  MoveStatistics statistics;
  Pairs expected;
  for (const ElementPair& pair : all_pairs(scene.mesh)) {
    if (start_distance(motion, pair) < epsilon) expected.push_back(pair);
  }
  std::ranges::sort(expected);
  const FoundContacts found = ContactSearch(scene.mesh, motion, epsilon, statistics).all();
  EXPECT_EQ(pairs_of(found.proximities), expected);
  EXPECT_GT(expected.size(), 0u);
  for (const Contact& contact : found.proximities) {
    const double distance = start_distance(motion, contact.pair);
    EXPECT_NEAR(contact.target, 0.1 * (epsilon - distance), 1e-12);
  }
}

TEST(ContactSearch, AgainFindsAllCollisionsOfTheChangedMotion) {
  Scene scene(0.1, 5);
  Motion motion(scene.mesh, scene.predicted, {});
  MoveStatistics statistics;
  ContactSearch search(scene.mesh, motion, 0, statistics);
  std::vector<Contact> collisions = search.all().collisions;
  std::uniform_int_distribution<std::size_t> pick(0, scene.mesh.vertex_slots() - 1);
  std::size_t found = 0;
  for (int round = 0; round < 20; ++round) {
    for (const Contact& contact : collisions) {
      for (Vertex v : contact.pair.vertices) motion.note_changed(v);
    }
    for (int i = 0; i < 5; ++i) {
      const Vertex v(pick(scene.random));
      motion.set_end(v, motion.starts()[v.index()] + random_vector(scene.random, 1));
    }
    collisions = search.again().collisions;
    EXPECT_TRUE(motion.changed().empty());
    MoveStatistics unused;
    std::vector<Vec3> ends(motion.ends().begin(), motion.ends().end());
    Motion same(scene.mesh, ends, {});
    ASSERT_EQ(pairs_of(collisions), pairs_of(ContactSearch(scene.mesh, same, 0, unused).all().collisions));
    found += collisions.size();
  }
  EXPECT_GT(found, 100u);
}

}  // namespace
}  // namespace lostopos
