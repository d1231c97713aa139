#include "LosTopos/shapes/voronoi_foam.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>

#include "Base/error.h"
#include "LosTopos/mesh/audit.h"
#include "LosTopos/mesh/measures.h"

namespace lostopos {
namespace {

// Vertices - edges + triangles of the film of one region.
long euler_of_region(const SurfaceMesh& mesh, Region region) {
  const auto bounds = [&](Triangle t) { return mesh.labels(t).has(region); };
  const auto is_used = [&](auto element) {
    const auto around = mesh.triangles(element);
    return std::any_of(around.begin(), around.end(), bounds);
  };
  long sum = 0;
  for (Vertex v : mesh.vertices()) sum += is_used(v);
  for (Edge e : mesh.edges()) sum -= is_used(e);
  for (Triangle t : mesh.triangles()) sum += bounds(t);
  return sum;
}

double shortest_edge(const SurfaceMesh& mesh) {
  double shortest = std::numeric_limits<double>::infinity();
  for (Edge e : mesh.edges()) shortest = std::min(shortest, length(mesh, e));
  return shortest;
}

void expect_sound_foam(const SurfaceMesh& mesh, long cells) {
  EXPECT_EQ(audit(mesh).text(), "clean");
  const auto volumes = region_volumes(mesh);
  ASSERT_EQ(volumes.size(), static_cast<std::size_t>(cells) + 1);
  EXPECT_EQ(volumes[0].region, air);
  EXPECT_NEAR(volumes[0].volume, -1, 1e-12) << "minus the volume of the box";
  double sum = 0;
  for (std::size_t i = 1; i < volumes.size(); ++i) {
    EXPECT_EQ(volumes[i].region, Region(i));
    EXPECT_GT(volumes[i].volume, 0.2 / static_cast<double>(cells));
    sum += volumes[i].volume;
    EXPECT_EQ(euler_of_region(mesh, Region(i)), 2) << "each bubble is a ball";
  }
  EXPECT_NEAR(sum, 1, 1e-12);
  // The walls are a sphere, and each bubble divides the inside by one ball: 1 + the number of bubbles.
  EXPECT_EQ(euler_characteristic(mesh), 1 + cells);
  for (Vertex v : mesh.vertices()) {
    for (double x : mesh.position(v)) EXPECT_TRUE(x >= 0 && x <= 1);
  }
}

class VoronoiFoam : public testing::TestWithParam<long> {};

TEST_P(VoronoiFoam, IsSoundForAnySeed) {
  const long cells = GetParam();
  double least = 1;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const SurfaceMesh mesh = voronoi_foam({.cells = cells, .seed = seed});
    expect_sound_foam(mesh, cells);
    least = std::min(least, shortest_edge(mesh) * std::cbrt(static_cast<double>(cells)));
    if (cells > 2) {
      EXPECT_GT(junction_edge_count(mesh), 0u);
    }
  }
  std::cout << "shortest edge over cells^(-1/3): " << least << "\n";
  EXPECT_GT(least, 0.02);
}

INSTANTIATE_TEST_SUITE_P(Cells, VoronoiFoam, testing::Values(1, 2, 5, 20, 60));

TEST(VoronoiFoamOptions, SubdivisionKeepsTheShape) {
  const SurfaceMesh coarse = voronoi_foam({.cells = 5, .seed = 3});
  const SurfaceMesh fine = voronoi_foam({.cells = 5, .seed = 3, .subdivisions = 2});
  expect_sound_foam(fine, 5);
  EXPECT_EQ(fine.triangle_count(), 16 * coarse.triangle_count());
  EXPECT_NEAR(total_area(fine), total_area(coarse), 1e-12);
  const auto before = region_volumes(coarse), after = region_volumes(fine);
  for (std::size_t i = 0; i < before.size(); ++i) EXPECT_NEAR(after[i].volume, before[i].volume, 1e-13);
}

TEST(VoronoiFoamOptions, RelaxationMakesBubblesAlike) {
  const auto spread = [](int relaxations) {
    const auto volumes = region_volumes(voronoi_foam({.cells = 60, .relaxations = relaxations}));
    double sum = 0;
    for (std::size_t i = 1; i < volumes.size(); ++i) sum += std::pow(60 * volumes[i].volume - 1, 2) / 60;
    return std::sqrt(sum);
  };
  EXPECT_LT(spread(10), 0.5 * spread(0));
}

// Without contraction it is the exact Voronoi diagram: the borders of films meet four at a point, three films at each.
TEST(VoronoiFoamOptions, WithoutContractionThreeFilmsMeetAtEveryBorder) {
  const SurfaceMesh mesh = voronoi_foam({.cells = 20, .shortest_side = 0});
  for (Edge e : mesh.edges()) EXPECT_LE(mesh.triangles(e).size(), 3u);
  EXPECT_EQ(euler_characteristic(mesh), 21);
}

TEST(VoronoiFoamOptions, SameSeedSameBits) {
  const SurfaceMesh a = voronoi_foam({.seed = 5}), b = voronoi_foam({.seed = 5}), c = voronoi_foam({.seed = 6});
  ASSERT_EQ(a.vertex_count(), b.vertex_count());
  ASSERT_EQ(a.triangle_count(), b.triangle_count());
  for (Vertex v : a.vertices()) EXPECT_EQ(a.position(v), b.position(v));
  for (Triangle t : a.triangles()) {
    EXPECT_EQ(a.vertices(t), b.vertices(t));
    EXPECT_EQ(a.labels(t).p, b.labels(t).p);
    EXPECT_EQ(a.labels(t).q, b.labels(t).q);
  }
  EXPECT_NE(total_area(a), total_area(c));
}

TEST(VoronoiFoamOptions, OutOfRangeIsRefused) {
  EXPECT_THROW(voronoi_foam({.cells = 0}), base::InputError);
  EXPECT_THROW(voronoi_foam({.cells = -3}), base::InputError);
  EXPECT_THROW(voronoi_foam({.relaxations = -1}), base::InputError);
  EXPECT_THROW(voronoi_foam({.subdivisions = -1}), base::InputError);
  EXPECT_THROW(voronoi_foam({.shortest_side = std::nan("")}), base::InputError);
  EXPECT_THROW(voronoi_foam({.shortest_side = 0.6}), base::InputError);
}

}  // namespace
}  // namespace lostopos
