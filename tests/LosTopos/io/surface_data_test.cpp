#include "LosTopos/io/surface_data.h"

#include <limits>

#include "tests/LosTopos/io/io_test_tools.h"

namespace lostopos {
namespace {

TEST(SurfaceData, MeshAndBackIsTheSame) {
  const SurfaceData data = two_tetrahedra();
  const SurfaceMesh mesh = to_mesh(data);
  EXPECT_EQ(mesh.vertex_count(), 6U);
  EXPECT_EQ(mesh.triangle_count(), 7U);
  for (std::size_t t = 0; t < data.triangles.size(); ++t) EXPECT_EQ(mesh.labels(Triangle(t)), data.labels[t]);
  expect_same_surface(from_mesh(mesh), data);
}

TEST(SurfaceData, GapsAreClosedInSlotOrder) {
  SurfaceMesh mesh = to_mesh(two_tetrahedra());
  for (const std::size_t t : {0U, 1U, 2U}) mesh.remove_triangle(Triangle(t));
  mesh.remove_vertex(Vertex(3));
  const SurfaceData data = from_mesh(mesh);
  EXPECT_EQ(data.positions.size(), 5U);
  EXPECT_EQ(data.triangles, (std::vector<std::array<std::uint32_t, 3>>{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}));
  const std::vector<std::uint32_t> expected{0, 1, 2, Vertex::invalid_index, 3, 4};
  EXPECT_EQ(compact_numbers(mesh), expected);
}

TEST(SurfaceData, DuplicateTrianglesAreAccepted) {
  SurfaceData data = two_tetrahedra();
  data.triangles.push_back(data.triangles[0]);
  data.labels.push_back(data.labels[0]);
  EXPECT_EQ(to_mesh(data).triangle_count(), 8U);
}

TEST(SurfaceData, RegionCountCoversLabelsCirculationAndDeclaration) {
  SurfaceData data = two_tetrahedra();
  EXPECT_EQ(region_count({}), 0U);
  EXPECT_EQ(region_count(data), 3U);
  EXPECT_EQ(region_count(two_tetrahedra_with_circulation()), 4U);
  data.declared_regions = 10;
  EXPECT_EQ(region_count(data), 10U);
}

using Damage = std::function<void(SurfaceData&)>;

TEST(SurfaceData, WhatIsNotValidIsRefused) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::pair<const char*, Damage> cases[] = {
      {"vertex 1: ", [](SurfaceData& d) { d.positions[1].y() = std::numeric_limits<double>::infinity(); }},
      {"vertex 1: the position is (1, 1e+100, ", [](SurfaceData& d) { d.positions[1].y() = 1e100; }},
      {"vertex 1: the position is (-1.", [](SurfaceData& d) { d.positions[1].x() = -1.01e40; }},
      {"triangle 0: the edge from ", [](SurfaceData& d) { d.positions[1] = d.positions[0] + Vec3(0, 1e-41, 0); }},
      {"triangle 2: ", [](SurfaceData& d) { d.triangles[2][0] = 6; }},
      {"triangle 2: ", [](SurfaceData& d) { d.triangles[2][0] = d.triangles[2][1]; }},
      {"triangle 3: ", [](SurfaceData& d) { d.labels[3].p = d.labels[3].q; }},
      {"triangle 3: ", [](SurfaceData& d) { d.labels[3].p = Region(); }},
      {"triangle 3: ", [](SurfaceData& d) { d.labels[3].p = Region{std::size_t{1} << 31U}; }},
      {"label pairs", [](SurfaceData& d) { d.labels.pop_back(); }},
      {"offsets", [](SurfaceData& d) { d.pair_arrays[0].offsets.pop_back(); }},
      {"offsets", [](SurfaceData& d) { d.pair_arrays[0].offsets.clear(); }},
      {"offsets", [](SurfaceData& d) { std::swap(d.pair_arrays[0].offsets[1], d.pair_arrays[0].offsets[2]); }},
      {"circulation at vertex 0",
       [](SurfaceData& d) { std::swap(d.pair_arrays[0].values[0], d.pair_arrays[0].values[1]); }},
      {"circulation at vertex 0", [](SurfaceData& d) { d.pair_arrays[0].values[1] = d.pair_arrays[0].values[0]; }},
      {"circulation at vertex 3", [](SurfaceData& d) { d.pair_arrays[0].values[9].p = Region{2}; }},
      {"circulation at vertex 3", [nan](SurfaceData& d) { d.pair_arrays[0].values[9].value = nan; }},
      {"held vertex 1", [](SurfaceData& d) { d.held[1].vertex = 6; }},
      {"held vertex 1", [nan](SurfaceData& d) { d.held[1].position.x() = nan; }},
      {"array 'a'",
       [](SurfaceData& d) {
         d.vertex_arrays = {{"a", 1, {1.0}}};
       }},
      {"array 'a'", [](SurfaceData& d) {
         d.triangle_arrays = {{"a", -1, std::vector<double>(7)}};
       }}};
  EXPECT_NO_THROW(validate(two_tetrahedra_with_circulation()));
  for (const auto& [message, damage] : cases) {
    SurfaceData data = two_tetrahedra_with_circulation();
    damage(data);
    expect_contains(input_error([&] { validate(data); }), message);
    EXPECT_THROW(to_mesh(data), base::InputError);
  }
}

}  // namespace
}  // namespace lostopos
