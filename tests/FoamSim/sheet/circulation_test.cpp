#include "FoamSim/sheet/circulation.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "FoamSim/scenes/shapes/double_bubble.h"
#include "FoamSim/scenes/shapes/solids.h"
#include "FoamSim/sheet/sheet_strength.h"
#include "FoamSim/sheet/surface_geometry.h"
#include "LosTopos/error.h"
#include "LosTopos/mesh/measures.h"
#include "LosTopos/mesh/state_json.h"
#include "tests/support/sample_meshes.h"

namespace foamsim {
namespace {

using lostopos::air;
using lostopos::Edge;
using lostopos::Labels;
using lostopos::Region;
using lostopos::SurfaceMesh;
using lostopos::Triangle;
using lostopos::Vec3;
using lostopos::Vertex;

constexpr Labels k10{Region(1), air}, k01{air, Region(1)}, k12{Region(1), Region(2)}, k21{Region(2), Region(1)},
    k20{Region(2), air};

TEST(Circulation, IsAntisymmetric) {
  SurfaceMesh mesh = double_bubble(8);
  CirculationField circulation(mesh);
  const Vertex v(0);
  circulation.set(v, k12, 2.5);
  circulation.set(v, k01, -1.25);
  EXPECT_EQ(circulation.get(v, k12), 2.5);
  EXPECT_EQ(circulation.get(v, k21), -2.5);
  EXPECT_EQ(circulation.get(v, k10), 1.25);
  EXPECT_EQ(circulation.get(v, k01), -1.25);
  EXPECT_EQ(circulation.get(v, k20), 0);
}

TEST(Circulation, HoldsOneValueOnAFilmAndThreeOnAPlateauBorder) {
  SurfaceMesh mesh = double_bubble(16);
  CirculationField circulation(mesh);
  std::size_t on_border = 0;
  for (Vertex v : mesh.vertices()) {
    const auto held = circulation.at(v);
    EXPECT_EQ(held.size(), mesh.is_junction(v) ? 3U : 1U);
    EXPECT_TRUE(std::ranges::is_sorted(held, {}, &PairCirculation::pair));
    for (const auto& [pair, value] : held) EXPECT_EQ(value, 0);
    on_border += mesh.is_junction(v) ? 1U : 0U;
  }
  EXPECT_EQ(on_border, 16U);
}

TEST(Circulation, AtTheCornersIsForTheTrianglesOwnOrder) {
  SurfaceMesh mesh = lostopos::test::corner_tetrahedron();
  CirculationField circulation(mesh);
  for (Vertex v : mesh.vertices()) circulation.set(v, k10, 1.0 + v.index());
  const Triangle t(0);
  const auto as_labelled = corner_circulation(mesh, circulation, t);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(as_labelled[i], 1.0 + mesh.vertices(t)[i].index());
  mesh.set_labels(t, k01);
  const auto flipped = corner_circulation(mesh, circulation, t);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(flipped[i], -as_labelled[i]);
}

TEST(CirculationMatch, ChangesNothingWhereThePairsAreRight) {
  SurfaceMesh mesh = double_bubble(8);
  CirculationField circulation(mesh);
  double value = 0;
  for (Vertex v : mesh.vertices())
    for (PairCirculation& held : circulation.at(v)) held.value = ++value;
  circulation.match(mesh);
  double expected = 0;
  for (Vertex v : mesh.vertices())
    for (const PairCirculation& held : circulation.at(v)) EXPECT_EQ(held.value, ++expected);
}

TEST(CirculationMatch, DropsPairsWithoutATriangle) {
  SurfaceMesh mesh = lostopos::test::corner_tetrahedron();
  CirculationField circulation(mesh);
  const Vertex v(0);
  circulation.set(v, k10, 3);
  circulation.set(v, k20, 5);
  ASSERT_EQ(circulation.at(v).size(), 2U);
  circulation.match(mesh);
  EXPECT_EQ(circulation.at(v).size(), 1U);
  EXPECT_EQ(circulation.get(v, k10), 3);
  EXPECT_EQ(circulation.get(v, k20), 0);
}

TEST(CirculationMatch, AMissingPairIsTheMeanOfTheNeighboursThatHoldIt) {
  SurfaceMesh mesh = lostopos::test::corner_tetrahedron();
  CirculationField circulation(mesh);
  for (std::size_t i = 0; i < 4; ++i) circulation.set(Vertex(i), k10, std::array{3.0, 4.0, 8.0, 0.0}[i]);
  const Vertex apex = mesh.add_vertex({-1, -1, -1});
  // Joined to vertices 0 and 1 only.
  mesh.add_triangle(apex, Vertex(0), Vertex(1), k10);
  circulation.match(mesh);
  EXPECT_EQ(circulation.get(apex, k10), 3.5);
  EXPECT_EQ(circulation.get(apex, k01), -3.5);
}

TEST(CirculationMatch, APairThatNobodyHeldStartsAtZero) {
  SurfaceMesh mesh = lostopos::test::corner_tetrahedron();
  CirculationField circulation(mesh);
  for (Vertex v : mesh.vertices()) circulation.set(v, k10, 7);
  for (Triangle t : mesh.triangles()) mesh.set_labels(t, k20);
  circulation.match(mesh);
  for (Vertex v : mesh.vertices()) {
    ASSERT_EQ(circulation.at(v).size(), 1U);
    EXPECT_EQ(circulation.get(v, k20), 0);
    EXPECT_EQ(circulation.get(v, k10), 0);
  }
}

TEST(CirculationMatch, NewVerticesDoNotLookAtEachOther) {
  // A strip 0-1-2-3: 1 and 2 are new; 1 sees the holder 0 only, 2 the holder 3 only, whatever the order of visits.
  SurfaceMesh mesh;
  for (int i = 0; i < 2; ++i) {
    mesh.add_vertex({i * 3.0, 0, 0});
    mesh.add_vertex({i * 3.0, 1, 0});
    mesh.add_vertex({i * 3.0, 0, 1});
    const std::size_t first = 3 * static_cast<std::size_t>(i);
    mesh.add_triangle(Vertex(first), Vertex(first + 1), Vertex(first + 2), k10);
  }
  CirculationField circulation(mesh);
  for (std::size_t i = 0; i < 3; ++i) {
    circulation.set(Vertex(i), k10, 10);
    circulation.set(Vertex(i + 3), k10, 20);
  }
  const Vertex near_first = mesh.add_vertex({1, 0, 0}), near_second = mesh.add_vertex({2, 0, 0});
  mesh.add_triangle(Vertex(0), Vertex(1), near_first, k10);
  mesh.add_triangle(Vertex(3), Vertex(4), near_second, k10);
  mesh.add_triangle(near_first, near_second, mesh.add_vertex({1.5, 1, 0}), k10);
  circulation.match(mesh);
  EXPECT_EQ(circulation.get(near_first, k10), 10);
  EXPECT_EQ(circulation.get(near_second, k10), 20);
}

TEST(Circulation, FollowsTheVerticesThroughCompaction) {
  SurfaceMesh mesh;
  lostopos::test::add_corner_tetrahedron(mesh, 1, {0, 0, 0}, Region(1), air);
  lostopos::test::add_corner_tetrahedron(mesh, 1, {5, 0, 0}, Region(2), air);
  CirculationField circulation(mesh);
  for (Vertex v : mesh.vertices()) circulation.set(v, v.index() < 4 ? k10 : k20, mesh.position(v).sum());
  for (std::size_t t = 0; t < 4; ++t) mesh.remove_triangle(Triangle(t));
  for (std::size_t v = 0; v < 4; ++v) mesh.remove_vertex(Vertex(v));
  mesh.compact();
  ASSERT_EQ(mesh.vertex_count(), 4U);
  for (Vertex v : mesh.vertices()) EXPECT_EQ(circulation.get(v, k20), mesh.position(v).sum());
}

// `count` double bubbles in a row; the bubbles of all, or only those of each, are different regions.
SurfaceMesh double_bubbles(std::size_t count, bool all_different) {
  const SurfaceMesh one = double_bubble(8);
  SurfaceMesh mesh;
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t first = mesh.vertex_count();
    for (Vertex v : one.vertices()) mesh.add_vertex(one.position(v) + Vec3(0, 3.0 * static_cast<double>(k), 0));
    auto renamed = [&](Region r) { return r == air || !all_different ? r : Region(2 * k + r.index()); };
    for (Triangle t : one.triangles()) {
      const auto& v = one.vertices(t);
      mesh.add_triangle(Vertex(first + v[0].index()), Vertex(first + v[1].index()), Vertex(first + v[2].index()),
                        {renamed(one.labels(t).p), renamed(one.labels(t).q)});
    }
  }
  return mesh;
}

TEST(CirculationMemory, TwoThousandRegionsTakeNoMoreThanTwo) {
  SurfaceMesh few = double_bubbles(1000, false), many = double_bubbles(1000, true);
  const CirculationField circulation_few(few), circulation_many(many);
  EXPECT_EQ(circulation_many.memory_bytes(), circulation_few.memory_bytes());
  EXPECT_LT(static_cast<double>(circulation_many.memory_bytes()) / static_cast<double>(many.vertex_count()), 64.0);
  EXPECT_EQ(many.memory_bytes(), few.memory_bytes());
}

TEST(CirculationMemory, PerVertexDoesNotGrowWithTheFoam) {
  SurfaceMesh one = double_bubbles(1, true), many = double_bubbles(1000, true);
  const CirculationField circulation_one(one), circulation_many(many);
  EXPECT_EQ(circulation_many.memory_bytes(), 1000 * circulation_one.memory_bytes());
}

bool same_values(const SurfaceMesh& mesh, const CirculationField& a, const CirculationField& b) {
  const auto same = [](const PairCirculation& x, const PairCirculation& y) {
    return x.pair == y.pair && x.value == y.value;
  };
  return std::ranges::all_of(mesh.vertices(), [&](Vertex v) { return std::ranges::equal(a.at(v), b.at(v), same); });
}

TEST(CirculationState, IsRestoredAndReadWithTheMesh) {
  SurfaceMesh mesh = double_bubble(16);
  CirculationField circulation(mesh);
  double next = 0;
  for (Vertex v : mesh.vertices())
    for (auto& [pair, value] : circulation.at(v)) value = std::sin(next += 1.7);
  const auto state = mesh.state();
  SurfaceMesh read = SurfaceMesh::from_state(
      lostopos::mesh_state_from_json(nlohmann::json::from_cbor(nlohmann::json::to_cbor(lostopos::to_json(state)))));
  const CirculationField taken_up(read);
  EXPECT_TRUE(same_values(mesh, circulation, taken_up));
  for (Vertex v : mesh.vertices()) circulation.set(v, k12, 9);
  EXPECT_FALSE(same_values(mesh, circulation, taken_up));
  mesh.restore(state);
  EXPECT_TRUE(same_values(mesh, circulation, taken_up));
}

TEST(CirculationState, ThatIsDamagedIsRefused) {
  SurfaceMesh mesh = double_bubble(8);
  const CirculationField circulation(mesh);
  const nlohmann::json whole = lostopos::to_json(mesh.state());
  const auto bytes = whole["vertex_attributes"]["circulation"]["bytes"].get_binary();
  for (std::size_t size : {std::size_t{0}, std::size_t{5}, bytes.size() / 2, bytes.size() - 1, bytes.size() - 16}) {
    nlohmann::json damaged = whole;
    damaged["vertex_attributes"]["circulation"]["bytes"] =
        nlohmann::json::binary(std::vector<std::uint8_t>(bytes.begin(), bytes.begin() + static_cast<long>(size)));
    SurfaceMesh read = SurfaceMesh::from_state(lostopos::mesh_state_from_json(damaged));
    EXPECT_THROW(CirculationField{read}, lostopos::MeshError) << size;
  }
}

TEST(Solids, AreTrianglesThatSaySoAndNoFilm) {
  SurfaceMesh mesh = double_bubble(8);
  const CirculationField circulation(mesh);
  std::vector<std::uint8_t> solid(mesh.triangle_slots(), 0);
  solid[3] = solid[5] = 1;
  std::vector<SheetTriangle> sheet;
  gather_sheet(mesh, circulation, sheet, solid);
  EXPECT_EQ(sheet.size(), mesh.triangle_count() - 2);
  for (const SheetTriangle& film : sheet) EXPECT_EQ(solid[film.triangle.index()], 0);
  SurfaceGeometry geometry;
  geometry.update(mesh, solid);
  EXPECT_NEAR(geometry.total_area(), lostopos::total_area(mesh) - area(mesh, Triangle(3)) - area(mesh, Triangle(5)),
              1e-12);
}

}  // namespace
}  // namespace foamsim
