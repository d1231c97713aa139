#include "LosTopos/collision/triangle_gap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "LosTopos/geometry/distance.h"

namespace lostopos {
namespace {

bool names_vertex(const SurfaceMesh& mesh, Triangle t, Vertex v) {
  return std::ranges::find(mesh.vertices(t), v) != mesh.vertices(t).end();
}

double vertices_to_triangle(const SurfaceMesh& mesh, Triangle t, Triangle u) {
  double least = HUGE_VAL;
  const auto& [a, b, c] = mesh.vertices(u);
  for (Vertex v : mesh.vertices(t))
    if (!names_vertex(mesh, u, v))
      least = std::min(
          least,
          point_triangle_distance(mesh.position(v), mesh.position(a), mesh.position(b), mesh.position(c)).distance);
  return least;
}

// Of elements without a common vertex.
double gap(const SurfaceMesh& mesh, Triangle t, Triangle u) {
  double least = std::min(vertices_to_triangle(mesh, t, u), vertices_to_triangle(mesh, u, t));
  for (Edge e : mesh.edges(t))
    for (Edge f : mesh.edges(u)) {
      const auto& [a, b] = mesh.vertices(e);
      const auto& [c, d] = mesh.vertices(f);
      if (a == c || a == d || b == c || b == d) continue;
      least = std::min(
          least,
          segment_segment_distance(mesh.position(a), mesh.position(b), mesh.position(c), mesh.position(d)).distance);
    }
  return least;
}

// Two random triangles, flat ones among them, that have `common` vertices in common.
void compare_with_all_distances(std::size_t common, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> component(-1, 1);
  int near = 0;
  constexpr int trials = 3000;
  for (int trial = 0; trial < trials; ++trial) {
    const double thickness = trial % 3 == 0 ? 0 : trial % 3 == 1 ? 0.1 : 1;
    SurfaceMesh mesh;
    std::vector<Vertex> v;
    for (std::size_t i = 0; i < 6 - common; ++i)
      v.push_back(mesh.add_vertex({component(random), component(random), thickness * component(random)}));
    const Labels labels{Region(1), air};
    const Triangle t = mesh.add_triangle(v[0], v[1], v[2], labels);
    const Triangle u = mesh.add_triangle(v[5 - common], v[3 - common], v[4 - common], labels);
    const double exact = gap(mesh, t, u), distance = 0.3;
    const PlacedTriangle x = placed_triangle(mesh, t, mesh.positions()), y = placed_triangle(mesh, u, mesh.positions());
    if (std::abs(exact - distance) < 1e-9) continue;
    ASSERT_EQ(have_near_elements(x, y, distance), exact < distance) << common << " in common, trial " << trial;
    ASSERT_EQ(have_near_elements(y, x, distance), exact < distance) << common << " in common, trial " << trial;
    if (exact < distance) {
      ++near;
      ASSERT_FALSE(is_beyond(x, mesh, u, mesh.positions(), distance));
      ASSERT_FALSE(is_beyond(y, mesh, t, mesh.positions(), distance));
    }
  }
  EXPECT_GT(near, trials / 20);
  EXPECT_LT(near, trials - trials / 20);
}

TEST(TriangleGap, TwoTrianglesApart) {
  compare_with_all_distances(0, 1);
}

TEST(TriangleGap, TwoTrianglesWithACommonVertex) {
  compare_with_all_distances(1, 2);
}

TEST(TriangleGap, TwoTrianglesWithACommonEdge) {
  compare_with_all_distances(2, 3);
}

TEST(TriangleGap, TrianglesWithoutAreaAreMeasured) {
  SurfaceMesh mesh;
  std::vector<Vertex> v;
  for (double x : {0.0, 1.0, 2.0}) v.push_back(mesh.add_vertex({x, 0, 0}));
  for (double x : {0.0, 1.0, 2.0}) v.push_back(mesh.add_vertex({x, 0.2, 0}));
  const Triangle t = mesh.add_triangle(v[0], v[1], v[2], {Region(1), air});
  const Triangle u = mesh.add_triangle(v[3], v[4], v[5], {Region(1), air});
  const PlacedTriangle x = placed_triangle(mesh, t, mesh.positions()), y = placed_triangle(mesh, u, mesh.positions());
  EXPECT_TRUE(have_near_elements(x, y, 0.201));
  EXPECT_FALSE(have_near_elements(x, y, 0.199));
}

}  // namespace
}  // namespace lostopos
