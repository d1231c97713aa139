// Good surfaces broken in each way a repair knows, and what it makes of them.
#include "LosTopos/io/repair/repair_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "LosTopos/mesh/audit.h"
#include "LosTopos/mesh/measures.h"
#include "LosTopos/shapes/solids.h"
#include "tests/support/film_meshes.h"
#include "tests/support/sample_meshes.h"

namespace lostopos {
namespace {

SurfaceData ball() {
  return from_mesh(icosphere(2));
}
SurfaceData two_bubbles() {
  return from_mesh(test::analytic_double_bubble(1, 12));
}

void turn(SurfaceData& data, std::size_t t) {
  std::swap(data.triangles[t][0], data.triangles[t][1]);
}

// Each triangle gets vertices of its own, as in files without shared ones.
void unweld(SurfaceData& data) {
  SurfaceData apart = data;
  apart.positions.clear();
  for (auto& triangle : apart.triangles)
    for (std::uint32_t& corner : triangle) {
      apart.positions.push_back(data.positions[corner]);
      corner = static_cast<std::uint32_t>(apart.positions.size() - 1);
    }
  data = apart;
}

// A vertex in the middle of an edge, on one side of it only: a triangle without area fills the gap.
void add_flat_triangle(SurfaceData& data) {
  const auto [a, b, c] = data.triangles[0];
  const Vec3 &x = data.positions[a], &y = data.positions[b];
  data.positions.push_back(0.5 * (x + y));
  const auto middle = static_cast<std::uint32_t>(data.positions.size() - 1);
  data.triangles[0] = {a, middle, c};
  data.triangles.push_back({middle, b, c});
  data.triangles.push_back({a, b, middle});
  data.labels.insert(data.labels.end(), 2, data.labels[0]);
}

void expect_mended(SurfaceData data, const std::string& word, double volume) {
  const RepairReport report = repair_surface(data);
  ASSERT_FALSE(report.done.empty()) << word;
  EXPECT_TRUE(std::ranges::any_of(report.done, [&](const auto& line) { return line.find(word) != line.npos; }))
      << report.done.front();
  EXPECT_TRUE(report.left.empty()) << word << ": " << report.left.front();
  EXPECT_EQ(audit(to_mesh(data)).text(), "clean");
  const auto volumes = region_volumes(to_mesh(data));
  EXPECT_NEAR(volumes.back().volume, volume, 1e-9) << word;
  SurfaceData again = data;
  EXPECT_TRUE(repair_surface(again).done.empty()) << word << ": a second repair finds more";
  EXPECT_EQ(again, data);
}

double last_volume(const SurfaceData& data) {
  return region_volumes(to_mesh(data)).back().volume;
}

TEST(RepairSurface, LeavesWhatIsSoundToTheBit) {
  for (const SurfaceData& sound : {ball(), two_bubbles()}) {
    SurfaceData data = sound;
    const RepairReport report = repair_surface(data);
    EXPECT_TRUE(report.done.empty());
    EXPECT_TRUE(report.left.empty());
    EXPECT_EQ(data, sound);
  }
}

TEST(RepairSurface, JoinsVerticesAtOnePlace) {
  for (SurfaceData data : {ball(), two_bubbles()}) {
    const double volume = last_volume(data);
    const std::size_t vertices = data.positions.size();
    unweld(data);
    expect_mended(data, "at the place of another", volume);
    repair_surface(data);
    EXPECT_EQ(data.positions.size(), vertices);
  }
}

TEST(RepairSurface, JoinsVerticesThatRoundingHasPartedAndNoOthers) {
  SurfaceData data = ball();
  const double volume = last_volume(data);
  unweld(data);
  for (std::size_t v = 0; v < data.positions.size(); ++v) data.positions[v].x() += 1e-12 * static_cast<double>(v % 7);
  SurfaceData apart = data;
  expect_mended(data, "at the place of another", volume);
  EXPECT_FALSE(repair_surface(apart, {.tolerance = 1e-15}).left.empty());
}

TEST(RepairSurface, TurnsTrianglesThatAreWoundAgainstTheirFilm) {
  for (SurfaceData data : {ball(), two_bubbles()}) {
    const double volume = last_volume(data);
    for (std::size_t t = 0; t < data.triangles.size(); t += 3) turn(data, t);
    expect_mended(data, "wound against", volume);
  }
}

TEST(RepairSurface, TurnsAFilmThatContradictsItsJunction) {
  SurfaceData data = two_bubbles();
  const double volume = last_volume(data);
  for (std::size_t t = 0; t < data.triangles.size(); ++t)
    if (!data.labels[t].has(air)) turn(data, t);
  expect_mended(data, "wound against", volume);
}

TEST(RepairSurface, TurnsWhatIsInsideOut) {
  SurfaceData data = ball();
  const double volume = last_volume(data);
  for (std::size_t t = 0; t < data.triangles.size(); ++t) turn(data, t);
  expect_mended(data, "inside out", volume);
}

TEST(RepairSurface, TurnsOneBubbleOfTwoThatIsInsideOut) {
  SurfaceMesh mesh;
  test::add_corner_tetrahedron(mesh, 1, {0, 0, 0}, Region(1), air);
  test::add_corner_tetrahedron(mesh, 1, {3, 0, 0}, air, Region(1));
  expect_mended(from_mesh(mesh), "inside out", 2.0 / 6);
}

TEST(RepairSurface, TakesTrianglesWithoutAreaAwayWithoutAGap) {
  for (SurfaceData data : {ball(), two_bubbles()}) {
    const double volume = last_volume(data);
    // Halves, so that the middle is on the line to the bit.
    for (Vec3& x : data.positions)
      for (double& coordinate : x) coordinate = std::round(coordinate * 1024) / 1024;
    const double rounded = last_volume(data);
    EXPECT_NEAR(rounded, volume, 0.02);
    add_flat_triangle(data);
    expect_mended(data, "without area", rounded);
  }
}

TEST(RepairSurface, TakesTrianglesOnOthersAway) {
  SurfaceData data = ball();
  const double volume = last_volume(data);
  for (const std::size_t t : {3U, 10U}) {
    data.triangles.push_back(data.triangles[t]);
    data.labels.push_back(data.labels[t]);
  }
  turn(data, data.triangles.size() - 1);
  data.labels.back() = data.labels.back().flipped();
  expect_mended(data, "on the corners of another", volume);
}

// Two tetrahedra, each with a face of its own where they touch.
TEST(RepairSurface, MakesOneFilmOfTheTwoWhereBubblesTouch) {
  SurfaceMesh mesh;
  test::add_corner_tetrahedron(mesh, 1, {0, 0, 0}, Region(1), air);
  test::add_corner_tetrahedron(mesh, 1, {0, 0, 0}, Region(2), air);
  SurfaceData data = from_mesh(mesh);
  for (std::size_t v = 4; v < 8; ++v) data.positions[v].z() *= -1;  // mirrored: inside out, and so turned
  for (std::size_t t = 4; t < 8; ++t) turn(data, t);
  expect_mended(data, "on the corners of another", 1.0 / 6);
}

TEST(RepairSurface, DropsUnusedVerticesAndKeepsArraysInStep) {
  SurfaceData data = ball();
  const double volume = last_volume(data);
  data.positions.emplace_back(5, 5, 5);
  unweld(data);
  data.positions.emplace_back(6, 6, 6);
  data.vertex_arrays.push_back({"x", 1, {}});
  for (const Vec3& x : data.positions) data.vertex_arrays[0].values.push_back(x.x());
  data.triangle_arrays.push_back({"number", 1, {}});
  for (std::size_t t = 0; t < data.triangles.size(); ++t) data.triangle_arrays[0].values.push_back(double(t));
  expect_mended(data, "that no triangle uses", volume);
  repair_surface(data);
  EXPECT_NO_THROW(validate(data));
  for (std::size_t v = 0; v < data.positions.size(); ++v)
    EXPECT_EQ(data.vertex_arrays[0].values[v], data.positions[v].x());
}

TEST(RepairSurface, SaysWhatIsLeftAndWhere) {
  SurfaceData hole = ball();
  hole.triangles.pop_back();
  hole.labels.pop_back();
  const RepairReport open = repair_surface(hole);
  ASSERT_EQ(open.left.size(), 3U);
  EXPECT_NE(open.left[0].find("open region"), std::string::npos) << open.left[0];
  EXPECT_NE(open.left[0].find("close it"), std::string::npos) << open.left[0];

  SurfaceMesh mesh;
  test::add_corner_tetrahedron(mesh, 1, {0, 0, 0}, Region(1), air);
  test::add_corner_tetrahedron(mesh, 1, {0.1, 0.1, 0.1}, Region(2), air);
  SurfaceData crossing = from_mesh(mesh);
  const SurfaceData before = crossing;
  const RepairReport report = repair_surface(crossing);
  EXPECT_TRUE(report.done.empty());
  ASSERT_FALSE(report.left.empty());
  EXPECT_NE(report.left[0].find("intersection"), std::string::npos) << report.left[0];
  EXPECT_EQ(crossing, before);
}

TEST(RepairSurface, DoesNotTurnASurfaceWithCirculation) {
  SurfaceData data = ball();
  for (std::size_t t = 0; t < data.triangles.size(); ++t) turn(data, t);
  PairArray circulation{"circulation", std::vector<std::size_t>(data.positions.size() + 1, 0), {}};
  data.pair_arrays.push_back(circulation);
  const SurfaceData before = data;
  EXPECT_FALSE(repair_surface(data).left.empty());
  EXPECT_EQ(data, before);
}

TEST(RepairSurface, TakesNothingAmiss) {
  SurfaceData nothing;
  EXPECT_TRUE(repair_surface(nothing).done.empty());
}

}  // namespace
}  // namespace lostopos
