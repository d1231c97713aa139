#include "LosTopos/topology/wide_tunnels.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "LosTopos/shapes/indexed_surface.h"
#include "LosTopos/topology/region_parts.h"

namespace lostopos {
namespace {

using Cell = std::array<int, 3>;

// Unit cubes of region 1; squares of two triangles each.
SurfaceMesh cubes(const std::set<Cell>& cells) {
  IndexedSurface solid;
  std::map<Cell, std::uint32_t> points;
  const auto point = [&](const Cell& at) {
    const auto [known, is_new] = points.try_emplace(at, static_cast<std::uint32_t>(solid.points.size()));
    if (is_new) solid.points.emplace_back(at[0], at[1], at[2]);
    return known->second;
  };
  for (const Cell& cell : cells)
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const int side : {0, 1}) {
        Cell beyond = cell;
        beyond[axis] += side == 1 ? 1 : -1;
        if (cells.contains(beyond)) continue;
        Cell a = cell;
        a[axis] += side;
        Cell b = a, c = a, d = a;
        ++b[(axis + 1) % 3], ++c[(axis + 1) % 3], ++c[(axis + 2) % 3], ++d[(axis + 2) % 3];
        if (side == 0) std::swap(b, d);
        solid.triangles.push_back({point(a), point(b), point(c)});
        solid.triangles.push_back({point(a), point(c), point(d)});
      }
  return as_bubble(solid);
}

// A ring of cubes of the given thickness around a square hole.
std::set<Cell> ring(int hole, int thickness) {
  std::set<Cell> cells;
  const int width = hole + 2 * thickness;
  for (int x = 0; x < width; ++x)
    for (int y = 0; y < width; ++y)
      for (int z = 0; z < thickness; ++z)
        if (std::min(x, y) < thickness || std::max(x, y) >= width - thickness) cells.insert({x, y, z});
  return cells;
}

double tunnels_for(const SurfaceMesh& mesh, Region region, double radius) {
  const RegionSurface surface(mesh, region);
  const auto pieces = surface.pieces(mesh);
  EXPECT_EQ(pieces.size(), 1u);
  return wide_tunnels(mesh, surface, pieces.front(), radius);
}

TEST(RegionSurface, OfATorusHasItsGenusFromBothSides) {
  const SurfaceMesh mesh = cubes(ring(2, 1));
  for (const Region region : {air, Region(1)}) {
    const RegionSurface surface(mesh, region);
    const auto pieces = surface.pieces(mesh);
    ASSERT_EQ(pieces.size(), 1u);
    EXPECT_EQ(pieces[0].genus, 1);
    EXPECT_TRUE(pieces[0].closed);
    EXPECT_NEAR(pieces[0].volume, region == air ? -12 : 12, 1e-12);
  }
}

// In an edge: the air goes by on both sides, so what it surrounds is one piece; inside they are two.
TEST(RegionSurface, OfCubesThatTouch) {
  const SurfaceMesh in_edge = cubes({{0, 0, 0}, {1, 1, 0}});
  EXPECT_EQ(RegionSurface(in_edge, air).pieces(in_edge).size(), 1u);
  EXPECT_EQ(RegionSurface(in_edge, air).pieces(in_edge)[0].genus, 0);
  EXPECT_EQ(RegionSurface(in_edge, Region(1)).pieces(in_edge).size(), 2u);
  const SurfaceMesh in_vertex = cubes({{0, 0, 0}, {1, 1, 1}});
  for (const Region region : {air, Region(1)}) {
    const auto pieces = RegionSurface(in_vertex, region).pieces(in_vertex);
    ASSERT_EQ(pieces.size(), 2u);
    for (const auto& piece : pieces) EXPECT_EQ(piece.genus, 0);
  }
}

TEST(RegionShape, CountsTunnelsThatTouchingDoesNotMake) {
  std::set<Cell> cells = ring(2, 1);
  EXPECT_EQ(region_shape(cubes(cells), air).tunnels, 1);
  cells.insert({-1, -1, 1});  // touches the ring in a vertex
  const RegionShape shape = region_shape(cubes(cells), air);
  EXPECT_EQ(shape.tunnels, 1);
  EXPECT_EQ(shape.pieces, 2u);
  EXPECT_EQ(shape.pockets, 0u);
}

// The farthest corner of the ring is 5.7 from any vertex at the hole.
TEST(WideTunnels, AHandleIsSmallWhereAllOfItIsNear) {
  const SurfaceMesh mesh = cubes(ring(3, 1));
  for (const Region region : {air, Region(1)}) {
    for (const double radius : {0.1, 1.0, 2.0, 3.0}) EXPECT_EQ(tunnels_for(mesh, region, radius), 1) << radius;
    for (const double radius : {5.8, 100.0}) EXPECT_EQ(tunnels_for(mesh, region, radius), 0) << radius;
  }
}

// A slab with a hole in its middle and one at its rim, from which the ways around are short.
TEST(WideTunnels, ANarrowTunnelIsSmallOnlyWithShortWaysAround) {
  std::set<Cell> cells;
  for (int x = 0; x < 11; ++x)
    for (int y = 0; y < 11; ++y) cells.insert({x, y, 0});
  EXPECT_EQ(tunnels_for(cubes(cells), air, 2.5), 0);
  cells.erase({5, 5, 0});
  EXPECT_EQ(tunnels_for(cubes(cells), air, 2.5), 1);
  cells.erase({1, 5, 0});
  EXPECT_EQ(tunnels_for(cubes(cells), air, 0.5), 2);
  EXPECT_EQ(tunnels_for(cubes(cells), air, 2.5), 1);
  EXPECT_EQ(tunnels_for(cubes(cells), air, 20), 0);
}

// Small handles are counted once, however many vertices see them.
TEST(WideTunnels, SmallHandlesTakeNothingFromLargeOnes) {
  std::set<Cell> cells = ring(8, 3);
  EXPECT_EQ(tunnels_for(cubes(cells), air, 3), 1);
  for (const int x : {4, 8}) cells.erase({x, 1, 2}), cells.erase({x, 0, 1}), cells.erase({x, 1, 1});
  EXPECT_EQ(region_shape(cubes(cells), air).tunnels, 3);
  EXPECT_EQ(tunnels_for(cubes(cells), air, 3), 1);
}

TEST(SurroundsOneSolid, WithoutLargePocketsAndTunnels) {
  std::set<Cell> block;
  for (int x = 0; x < 5; ++x)
    for (int y = 0; y < 5; ++y)
      for (int z = 0; z < 5; ++z) block.insert({x, y, z});
  EXPECT_TRUE(surrounds_one_solid(cubes(block), air, {.pocket = 1, .tunnel = 1}));
  std::set<Cell> with_pocket = block;
  with_pocket.erase({2, 2, 2});
  EXPECT_FALSE(surrounds_one_solid(cubes(with_pocket), air, {.pocket = 1.2, .tunnel = 9}));  // a ball's volume is 0.9
  EXPECT_TRUE(surrounds_one_solid(cubes(with_pocket), air, {.pocket = 1.3, .tunnel = 9}));
  std::set<Cell> with_tunnel = block;
  for (int z = 0; z < 5; ++z) with_tunnel.erase({2, 2, z});
  EXPECT_FALSE(surrounds_one_solid(cubes(with_tunnel), air, {.pocket = 9, .tunnel = 3}));
  EXPECT_TRUE(surrounds_one_solid(cubes(with_tunnel), air, {.pocket = 9, .tunnel = 9}));
  std::set<Cell> with_other = block;
  with_other.insert({9, 9, 9});
  EXPECT_FALSE(surrounds_one_solid(cubes(with_other), air, {.pocket = 1, .tunnel = 1}));
}

}  // namespace
}  // namespace lostopos
