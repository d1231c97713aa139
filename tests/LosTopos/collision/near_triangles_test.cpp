#include "LosTopos/collision/near_triangles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "FoamSim/scenes/shapes/double_bubble.h"
#include "LosTopos/collision/contact_search.h"
#include "LosTopos/collision/triangle_gap.h"
#include "LosTopos/mesh/measures.h"
#include "LosTopos/remeshing/remesher.h"
#include "LosTopos/surface_tracker.h"
#include "tests/LosTopos/collision/move_checks.h"
#include "tests/support/film_meshes.h"

namespace lostopos {
namespace {

Vec3 random_step(std::mt19937& random, double size) {
  std::uniform_real_distribution<double> component(-1, 1);
  const Vec3 d(component(random), component(random), component(random));
  return size / std::sqrt(3.0) * d;
}

// Flattens the bubbles and brings the sides of each near each other.
SurfaceMesh flat_double_bubble(int n) {
  SurfaceMesh mesh = foamsim::double_bubble(n);
  for (Vertex v : mesh.vertices()) {
    Vec3 x = mesh.position(v);
    x[2] *= 0.15;
    mesh.set_position(v, x);
  }
  return mesh;
}

bool lists(std::span<const Triangle> list, Triangle t) {
  return std::ranges::find(list, t) != list.end();
}

// Every two triangles with elements nearer than the reach are in each other's list, and lists hold what lives.
void expect_all_near(const SurfaceMesh& mesh, const NearTriangles& near, std::size_t& found) {
  for (Triangle t : mesh.triangles()) {
    const PlacedTriangle placed = placed_triangle(mesh, t, mesh.positions());
    for (Triangle u : near.near(t)) {
      ASSERT_TRUE(mesh.alive(u));
      ASSERT_TRUE(lists(near.near(u), t));
    }
    for (Triangle u : mesh.triangles()) {
      if (u <= t || !have_near_elements(placed, placed_triangle(mesh, u, mesh.positions()), near.margins().reach))
        continue;
      ASSERT_TRUE(lists(near.near(t), u)) << t.index() << " and " << u.index();
      ++found;
    }
  }
}

void expect_overlapping_found(const SurfaceMesh& mesh, const NearTriangles& near, std::mt19937& random) {
  std::vector<Triangle> found, expected;
  for (int i = 0; i < 20; ++i) {
    const Vec3 centre = random_step(random, 2), size = random_step(random, 0.5).cwiseAbs();
    const Box box{centre - size, centre + size};
    near.overlapping(mesh, box, found);
    expected.clear();
    for (Triangle t : mesh.triangles())
      if (triangle_box(mesh, t, mesh.positions(), 0).overlaps(box)) expected.push_back(t);
    ASSERT_EQ(found, expected);
  }
}

TEST(NearTriangles, ListsWhatIsNearWhileVerticesMove) {
  SurfaceMesh mesh = flat_double_bubble(8);
  const double h = mean_edge_length(mesh);
  NearTriangles near({.reach = 0.3 * h, .slack = 0.1 * h});
  std::mt19937 random(1);
  std::size_t found = 0;
  for (int step = 0; step < 20; ++step) {
    std::vector<Vec3> to = test::positions_of(mesh);
    // Some vertices go far, some little.
    for (std::size_t i = 0; i < to.size(); ++i) to[i] += random_step(random, (i % 5 == 0 ? 0.1 : 0.02) * h);
    ASSERT_TRUE(near.follow(mesh, mesh.positions(), to));
    near.complete(mesh);
    expect_all_near(mesh, near, found);
    for (Vertex v : mesh.vertices()) mesh.set_position(v, to[v.index()]);
    expect_all_near(mesh, near, found);
    expect_overlapping_found(mesh, near, random);
  }
  EXPECT_GT(found, 100U);
}

TEST(NearTriangles, SaysWhenAMotionIsTooLongAndFollowsItsStart) {
  SurfaceMesh mesh = flat_double_bubble(8);
  const double h = mean_edge_length(mesh);
  NearTriangles near({.reach = 0.3 * h, .slack = 0.1 * h});
  std::vector<Vec3> to = test::positions_of(mesh);
  to[3] += Vec3(0.21 * h, 0, 0);
  std::size_t found = 0;
  EXPECT_FALSE(near.follow(mesh, mesh.positions(), to));
  near.complete(mesh);
  expect_all_near(mesh, near, found);
  to[3] = mesh.position(Vertex(3)) + Vec3(0.19 * h, 0, 0);
  EXPECT_TRUE(near.follow(mesh, mesh.positions(), to));
  EXPECT_TRUE(near.covers(Vertex(3), mesh.position(Vertex(3))));
  EXPECT_TRUE(near.covers(Vertex(3), to[3]));
  EXPECT_GT(found, 0U);
}

TEST(NearTriangles, FollowsOperations) {
  SurfaceMesh mesh = flat_double_bubble(10);
  RemeshOptions options;
  options.target_edge = mean_edge_length(mesh);
  auto held = mesh.add_vertex_attribute<Hold>(Hold::none);
  NearTriangles near({.reach = 0.5 * options.target_edge, .slack = 0.1 * options.target_edge});
  std::mt19937 random(2);
  std::size_t done = 0, found = 0;
  for (int step = 0; step < 12; ++step) {
    for (Vertex v : mesh.vertices()) {
      const Vec3& x = mesh.position(v);
      mesh.set_position(v, Vec3(1.06 * x[0], x[1], x[2] / 1.06));
    }
    done += Remesher(mesh, held, options).run(&near).done_in_all();
    // What operations have told it is all there is to know.
    near.complete(mesh);
    expect_all_near(mesh, near, found);
    expect_overlapping_found(mesh, near, random);
    if (step == 8) mesh.compact();
    near.follow(mesh, mesh.positions(), mesh.positions());
    near.complete(mesh);
    expect_all_near(mesh, near, found);
  }
  EXPECT_GT(done, 50U);
  EXPECT_GT(found, 0U);
}

// While many lists are missing a search is said to be better, until so many have asked that it pays to make them.
TEST(NearTriangles, MakesManyMissingListsWhenEnoughHaveAsked) {
  SurfaceMesh mesh = flat_double_bubble(28);
  const double h = mean_edge_length(mesh);
  NearTriangles near({.reach = 0.5 * h, .slack = 0.1 * h});
  near.follow(mesh, mesh.positions(), mesh.positions());
  near.complete(mesh);
  std::size_t changed = 0;
  for (Triangle t : mesh.triangles()) {
    const auto x = corners(mesh, t);
    if (std::ranges::any_of(x, [](const Vec3& corner) { return corner[0] < 0.5; })) continue;
    for (Vertex v : mesh.vertices(t)) mesh.set_position(v, 1.0001 * mesh.position(v) + Vec3(0.2 * h, 0, 0));
    near.changed(mesh, t);
    ++changed;
  }
  ASSERT_GT(changed, 600U);
  Vertex left(0);
  for (Vertex v : mesh.vertices())
    if (mesh.position(v)[0] < mesh.position(left)[0]) left = v;
  std::vector<Triangle> found;
  std::size_t asked = 1;
  for (; !near.append_around(mesh, left, found) && asked < 10 * changed; ++asked) found.clear();
  EXPECT_GT(asked, changed / 2);
  EXPECT_LT(asked, 4 * changed);
  for (Triangle t : mesh.triangles(left))
    for (Triangle u : near.near(t)) EXPECT_TRUE(lists(found, u));
  std::size_t pairs = 0;
  expect_all_near(mesh, near, pairs);
  EXPECT_GT(pairs, 0U);
}

void expect_same(const std::vector<Contact>& a, const std::vector<Contact>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].pair, b[i].pair);
    EXPECT_EQ(a[i].weights, b[i].weights);
    EXPECT_EQ(a[i].normal, b[i].normal);
    EXPECT_EQ(a[i].time, b[i].time);
    EXPECT_EQ(a[i].target, b[i].target);
  }
}

TEST(NearTriangles, ContactSearchFindsTheSameWithAndWithout) {
  SurfaceMesh mesh = flat_double_bubble(10);
  const double h = mean_edge_length(mesh);
  for (Vertex v : mesh.vertices()) mesh.set_position(v, mesh.position(v).cwiseProduct(Vec3(1, 1, 0.1)));
  NearTriangles near({.reach = 0.02 * h, .slack = 0.1 * h});
  std::mt19937 random(3);
  std::size_t collisions = 0;
  for (double size : {0.02, 0.1, 0.15, 0.5}) {
    std::vector<Vec3> to = test::positions_of(mesh);
    for (Vec3& x : to) x += random_step(random, size * h);
    Motion with_lists(mesh, to, {}), without(mesh, to, {});
    MoveStatistics statistics;
    ContactSearch listed(mesh, with_lists, 0.02 * h, statistics, &near), plain(mesh, without, 0.02 * h, statistics);
    FoundContacts a = listed.all(), b = plain.all();
    expect_same(a.proximities, b.proximities);
    expect_same(a.collisions, b.collisions);
    collisions += a.collisions.size();
    // Changes within the slack, and then some that leave it.
    for (double change : {0.01, 0.3}) {
      for (std::size_t i = 0; i < to.size(); i += 7) {
        const Vec3 end = to[i] + random_step(random, change * h);
        with_lists.set_end(Vertex(i), end);
        without.set_end(Vertex(i), end);
      }
      a = listed.again();
      b = plain.again();
      expect_same(a.collisions, b.collisions);
      collisions += a.collisions.size();
    }
  }
  EXPECT_GT(collisions, 100U);
}

// One tracker keeps its lists; another is made anew from the surface before every step.
TEST(NearTriangles, StepsDoNotDependOnWhatWasListedBefore) {
  TrackerOptions options{.resolution = mean_edge_length(flat_double_bubble(10))};
  options.topology.enabled = true;
  SurfaceTracker kept(flat_double_bubble(10), options);
  SurfaceTracker::State state = kept.state();
  std::size_t changes = 0;
  for (int step = 0; step < 12; ++step) {
    SurfaceTracker fresh(SurfaceMesh::from_state(state), options);
    std::vector<Vec3> to = test::positions_of(kept.mesh());
    for (Vec3& x : to) x += 0.15 * options.resolution * Vec3(std::sin(3 * x[1]), std::cos(2 * x[0]), -2 * x[2]);
    const TrackerStep a = kept.step(to), b = fresh.step(to);
    changes += a.topology.done_in_all();
    ASSERT_EQ(a.remesh.done_in_all(), b.remesh.done_in_all());
    ASSERT_TRUE(test::same_bits(kept.state(), fresh.state())) << "step " << step;
    state = kept.state();
  }
  EXPECT_GT(changes, 0U);
}

}  // namespace
}  // namespace lostopos
