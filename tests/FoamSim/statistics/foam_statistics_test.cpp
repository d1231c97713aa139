// Foams whose bubbles, films and borders are known by hand, in closed form, or by Euler's formula.
#include "FoamSim/statistics/foam_statistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "FoamSim/scenes/shapes/exact_double_bubble.h"
#include "LosTopos/shapes/solids.h"
#include "LosTopos/shapes/voronoi_foam.h"
#include "kelvin_cell.h"
#include "tests/support/sample_meshes.h"

namespace foamsim::test {
namespace {

using lostopos::air;
using lostopos::Region;
using lostopos::SurfaceMesh;
using lostopos::Vec3;
using lostopos::Vertex;

// 2 for a cell without holes whose faces are discs.
long euler(const BubbleStatistics& bubble) {
  return static_cast<long>(bubble.vertices + bubble.faces + bubble.loops) - static_cast<long>(bubble.edges);
}

// Three bubbles about the z axis, symmetric: six corners, nine triangles.
SurfaceMesh triple_bubble() {
  SurfaceMesh mesh;
  const Vertex bottom = mesh.add_vertex({0, 0, -1}), top = mesh.add_vertex({0, 0, 1});
  std::array<Vertex, 3> ring;
  for (std::size_t i = 0; i < 3; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / 3;
    ring.at(i) = mesh.add_vertex({std::cos(angle), std::sin(angle), 0});
  }
  for (std::uint32_t i = 0; i < 3; ++i) {
    const Region bubble{i + 1}, before{(i + 2) % 3 + 1};
    const Vertex a = ring.at(i), b = ring.at((i + 1) % 3);
    mesh.add_triangle(a, b, top, {bubble, air});
    mesh.add_triangle(b, a, bottom, {bubble, air});
    mesh.add_triangle(bottom, a, top, {bubble, before});
  }
  return mesh;
}

TEST(FoamStatistics, OfASphere) {
  const FoamStatistics foam = foam_statistics(lostopos::icosphere(4, 0.5));
  ASSERT_EQ(foam.bubbles.size(), 1u);
  const BubbleStatistics& bubble = foam.bubbles[0];
  EXPECT_EQ(bubble.region, Region(1));
  EXPECT_EQ(bubble.faces, 1u);
  EXPECT_EQ(bubble.edges + bubble.vertices + bubble.neighbours + bubble.loops, 0u);
  EXPECT_NEAR(*bubble.volume, std::numbers::pi / 6, 2e-3);
  EXPECT_NEAR(bubble.area, std::numbers::pi, 1e-2);
  EXPECT_EQ(bubble.air_area, bubble.area);
  EXPECT_NEAR(*bubble.pressure, 4, 1e-2);  // 2/R
  EXPECT_EQ(foam.inner_bubbles(), 0u);
  EXPECT_FALSE(foam.inner_faces().mean);
  EXPECT_NEAR(*foam.polydispersity(), 0, 1e-12);
}

TEST(FoamStatistics, OfADoubleBubbleAsInClosedForm) {
  const DoubleBubbleEquilibrium exact = double_bubble_equilibrium(1, 2.5);
  const FoamStatistics foam = foam_statistics(exact_double_bubble(exact, 96));
  ASSERT_EQ(foam.bubbles.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    const BubbleStatistics& bubble = foam.bubbles[i];
    EXPECT_NEAR(*bubble.volume, exact.volumes.at(i), 5e-3 * exact.volumes.at(i));
    EXPECT_NEAR(bubble.air_area, exact.outer.at(i).area, 5e-3 * exact.outer.at(i).area);
    EXPECT_NEAR(bubble.area - bubble.air_area, exact.wall.area, 5e-3 * exact.wall.area);
    EXPECT_NEAR(*bubble.pressure, exact.pressure(i), 5e-3 * exact.pressure(i));
    EXPECT_EQ(bubble.faces, 2u);
    EXPECT_EQ(bubble.edges, 1u);
    EXPECT_EQ(bubble.loops, 1u);
    EXPECT_EQ(bubble.vertices, 0u);
    EXPECT_EQ(bubble.neighbours, 1u);
    EXPECT_EQ(euler(bubble), 2);
  }
  ASSERT_EQ(foam.network.borders.size(), 1u);
  EXPECT_NEAR(foam.border_length(), 2 * std::numbers::pi * exact.rim_radius, 5e-3 * exact.rim_radius);
}

TEST(FoamStatistics, OfATripleBubbleByHand) {
  const FoamStatistics foam = foam_statistics(triple_bubble());
  ASSERT_EQ(foam.bubbles.size(), 3u);
  for (const BubbleStatistics& bubble : foam.bubbles) {
    EXPECT_NEAR(*bubble.volume, std::sqrt(3) / 6, 1e-12);
    EXPECT_EQ(bubble.faces, 3u);
    EXPECT_EQ(bubble.edges, 3u);
    EXPECT_EQ(bubble.vertices, 2u);
    EXPECT_EQ(bubble.loops, 0u);
    EXPECT_EQ(bubble.neighbours, 2u);
    EXPECT_NEAR(bubble.area - bubble.air_area, 2, 1e-12);
    EXPECT_EQ(euler(bubble), 2);
  }
  EXPECT_EQ(foam.network.films.size(), 6u);
  EXPECT_EQ(foam.network.borders.size(), 4u);  // the axis, and three towards the air
  EXPECT_EQ(foam.network.vertices.size(), 2u);
  EXPECT_NEAR(foam.border_length(), 2 + 6 * std::sqrt(2), 1e-12);
}

TEST(FoamStatistics, OfKelvinsCell) {
  const FoamStatistics foam = foam_statistics(kelvin_cell());
  const BubbleStatistics& cell = foam.bubbles.front();
  EXPECT_EQ(cell.faces, 14u);
  EXPECT_EQ(cell.edges, 36u);
  EXPECT_EQ(cell.vertices, 24u);
  EXPECT_EQ(cell.neighbours, 14u);
  EXPECT_NEAR(*cell.volume, 8 * std::sqrt(2) * std::pow(std::sqrt(2), 3), 1e-9);  // of side √2
  EXPECT_EQ(foam.inner_bubbles(), foam.bubbles.size());
}

TEST(FoamStatistics, CellsOfAVoronoiFoamAreSimple) {
  const FoamStatistics foam =
      foam_statistics(lostopos::voronoi_foam({.cells = 60, .seed = 3, .subdivisions = 1, .shortest_side = 0}));
  ASSERT_EQ(foam.bubbles.size(), 60u);
  double volume = 0;
  for (const BubbleStatistics& bubble : foam.bubbles) {
    EXPECT_EQ(euler(bubble), 2) << bubble.region.index();
    EXPECT_EQ(2 * bubble.edges, 3 * bubble.vertices)
        << bubble.region.index();  // three borders meet at each of its vertices
    EXPECT_EQ(bubble.neighbours + (bubble.air_area > 0 ? 1 : 0), bubble.faces) << bubble.region.index();
    volume += *bubble.volume;
  }
  EXPECT_NEAR(volume, 1, 1e-9);
  // Each border belongs to three films, each vertex to four borders.
  EXPECT_EQ(2 * foam.network.borders.size(), 4 * foam.network.vertices.size());
  EXPECT_DOUBLE_EQ(*foam.film_edges().mean, 3.0 * static_cast<double>(foam.network.borders.size()) /
                                                static_cast<double>(foam.network.films.size()));
  EXPECT_GT(*foam.polydispersity(), 0);
}

TEST(FoamStatistics, WhatIsNotClosedHasNeitherVolumeNorPressure) {
  const FoamStatistics foam = foam_statistics(lostopos::test::open_cylinder(1, 12, 4, 0.5));
  ASSERT_EQ(foam.bubbles.size(), 1u);
  EXPECT_FALSE(foam.bubbles[0].volume);
  EXPECT_FALSE(foam.bubbles[0].pressure);
  EXPECT_EQ(foam.bubbles[0].faces, 1u);
}

TEST(FoamStatistics, SolidsAreNoFilms) {
  const SurfaceMesh mesh = lostopos::icosphere(2);
  std::vector<std::uint8_t> solid(mesh.triangle_slots(), 0);
  solid[0] = 1;
  const FoamStatistics foam = foam_statistics(mesh, solid);
  ASSERT_EQ(foam.bubbles.size(), 1u);
  EXPECT_LT(foam.film_area(), foam_statistics(mesh).film_area());
  EXPECT_FALSE(foam.bubbles[0].volume);
}

TEST(FoamStatistics, OfNothing) {
  const FoamStatistics foam = foam_statistics(SurfaceMesh());
  EXPECT_TRUE(foam.bubbles.empty());
  EXPECT_FALSE(foam.volumes().mean);
  EXPECT_FALSE(foam.polydispersity());
}

}  // namespace
}  // namespace foamsim::test
