#include "LosTopos/mesh/place_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>
#include <set>

#include "LosTopos/mesh/audit.h"
#include "LosTopos/mesh/measures.h"
#include "LosTopos/surface_tracker.h"
#include "tests/support/film_meshes.h"

namespace lostopos {
namespace {

std::vector<std::uint32_t> shuffled(std::size_t count, std::mt19937& random) {
  std::vector<std::uint32_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0U);
  std::ranges::shuffle(numbers, random);
  return numbers;
}

// The same surface with its elements in no order.
SurfaceMesh in_disorder(const SurfaceMesh& mesh, std::mt19937& random) {
  SurfaceMesh result;
  std::vector<Vertex> renamed(mesh.vertex_slots());
  for (std::uint32_t v : shuffled(mesh.vertex_slots(), random))
    renamed[v] = result.add_vertex(mesh.position(Vertex(v)));
  for (std::uint32_t t : shuffled(mesh.triangle_slots(), random)) {
    const auto& [a, b, c] = mesh.vertices(Triangle(t));
    result.add_triangle(renamed[a.index()], renamed[b.index()], renamed[c.index()], mesh.labels(Triangle(t)));
  }
  return result;
}

// How far the ends of edges, and edges and triangles from their vertices, are from each other in memory, over all of
// it; on the average.
double mean_way(const SurfaceMesh& mesh) {
  const auto at = [](std::size_t index, std::size_t slots) {
    return static_cast<double>(index) / static_cast<double>(slots);
  };
  double sum = 0;
  std::size_t count = 0;
  const auto add = [&](double a, double b) {
    sum += std::abs(a - b);
    ++count;
  };
  for (Edge e : mesh.edges()) {
    const double a = at(mesh.vertices(e)[0].index(), mesh.vertex_slots());
    add(a, at(mesh.vertices(e)[1].index(), mesh.vertex_slots()));
    add(a, at(e.index(), mesh.edge_slots()));
  }
  for (Triangle t : mesh.triangles())
    add(at(mesh.vertices(t)[0].index(), mesh.vertex_slots()), at(t.index(), mesh.triangle_slots()));
  return sum / static_cast<double>(count);
}

using Corner = std::array<double, 3>;
std::multiset<std::pair<std::array<Corner, 3>, std::array<std::uint32_t, 2>>> films_of(const SurfaceMesh& mesh) {
  std::multiset<std::pair<std::array<Corner, 3>, std::array<std::uint32_t, 2>>> films;
  for (Triangle t : mesh.triangles()) {
    std::array<Corner, 3> x;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3& p = mesh.position(mesh.vertices(t)[i]);
      x[i] = {p[0], p[1], p[2]};
    }
    films.insert({x, {mesh.labels(t).p.index(), mesh.labels(t).q.index()}});
  }
  return films;
}

TEST(PlaceOrder, KeepsEveryOctantTogether) {
  constexpr int n = 8;
  std::vector<Vec3> points;
  for (int x = 0; x < n; ++x)
    for (int y = 0; y < n; ++y)
      for (int z = 0; z < n; ++z) points.emplace_back(x, y, z);
  std::mt19937 random(1);
  std::vector<std::uint32_t> slots = shuffled(points.size(), random);
  sort_by_place(slots, points);
  ASSERT_EQ(std::set(slots.begin(), slots.end()).size(), points.size());
  for (std::uint32_t side : {2U, 4U}) {
    const std::uint32_t of_octant = side * side * side;
    for (std::size_t first = 0; first < slots.size(); first += of_octant) {
      const auto octant = [&](std::uint32_t slot) { return (points[slot] / side).array().floor().eval(); };
      for (std::size_t i = first; i < first + of_octant; ++i)
        EXPECT_TRUE((octant(slots[i]) == octant(slots[first])).all()) << side << " " << i;
    }
  }
}

TEST(PlaceOrder, PointsInOnePlaceStayAsTheyAre) {
  const std::vector<Vec3> points(5, Vec3(1, 2, 3));
  std::vector<std::uint32_t> slots = {3, 1, 4}, none;
  sort_by_place(slots, points);
  sort_by_place(none, points);
  EXPECT_EQ(slots, (std::vector<std::uint32_t>{3, 1, 4}));
}

TEST(PlaceOrder, CompactionBringsTogetherWhatIsNear) {
  std::mt19937 random(2);
  SurfaceMesh mesh = in_disorder(test::analytic_double_bubble(1, 40), random);
  EXPECT_TRUE(is_scattered(mesh));
  const double before = mean_way(mesh);
  const auto films = films_of(mesh);
  mesh.compact(SlotOrder::by_place);
  EXPECT_FALSE(is_scattered(mesh));
  EXPECT_LT(mean_way(mesh), before / 8);
  EXPECT_EQ(films_of(mesh), films);
  EXPECT_TRUE(audit(mesh).clean());
}

TEST(PlaceOrder, TheTrackerPutsALargeSurfaceInOrderAndLeavesASmallOneAlone) {
  for (const long n : {20, 190}) {
    std::mt19937 random(3);
    SurfaceMesh mesh = in_disorder(test::analytic_double_bubble(1, n), random);
    TrackerOptions options;
    options.remeshing = true;
    options.resolution = mean_edge_length(mesh);
    SurfaceTracker tracker(std::move(mesh), options);
    tracker.remesh();
    EXPECT_EQ(is_scattered(tracker.mesh()), tracker.mesh().triangle_count() < 50'000) << n;
    EXPECT_TRUE(audit(tracker.mesh(), {.intersections = false}).clean());
  }
}

}  // namespace
}  // namespace lostopos
