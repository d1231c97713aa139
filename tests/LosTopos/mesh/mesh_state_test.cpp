#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "LosTopos/error.h"
#include "LosTopos/mesh/audit.h"
#include "LosTopos/mesh/hold.h"
#include "LosTopos/mesh/state_json.h"
#include "LosTopos/mesh/surface_mesh.h"
#include "tests/support/sample_meshes.h"

namespace lostopos {
namespace {

template <class H>
std::vector<std::uint32_t> indices(std::span<const H> handles) {
  std::vector<std::uint32_t> result;
  for (H h : handles) result.push_back(h.index());
  return result;
}

// Slots, gaps, positions, labels and the order of all incidence lists.
void expect_same_to_the_bit(const SurfaceMesh& a, const SurfaceMesh& b) {
  ASSERT_EQ(a.vertex_slots(), b.vertex_slots());
  ASSERT_EQ(a.edge_slots(), b.edge_slots());
  ASSERT_EQ(a.triangle_slots(), b.triangle_slots());
  for (std::size_t i = 0; i < a.vertex_slots(); ++i) {
    const Vertex v(i);
    ASSERT_EQ(a.alive(v), b.alive(v));
    EXPECT_EQ(a.position(v), b.position(v));
    EXPECT_EQ(indices(a.edges(v)), indices(b.edges(v)));
    EXPECT_EQ(indices(a.triangles(v)), indices(b.triangles(v)));
  }
  for (std::size_t i = 0; i < a.edge_slots(); ++i) {
    const Edge e(i);
    ASSERT_EQ(a.alive(e), b.alive(e));
    EXPECT_EQ(a.vertices(e), b.vertices(e));
    EXPECT_EQ(indices(a.triangles(e)), indices(b.triangles(e)));
  }
  for (std::size_t i = 0; i < a.triangle_slots(); ++i) {
    const Triangle t(i);
    ASSERT_EQ(a.alive(t), b.alive(t));
    EXPECT_EQ(a.vertices(t), b.vertices(t));
    EXPECT_EQ(a.edges(t), b.edges(t));
    EXPECT_EQ(a.labels(t), b.labels(t));
  }
}

// Dead slots of every kind.
SurfaceMesh mesh_with_gaps() {
  SurfaceMesh mesh = test::triple_junction({120, 120, 120}).mesh;
  for (std::size_t i = 5; i < mesh.triangle_slots(); i += 4) mesh.remove_triangle(Triangle(i));
  for (Vertex v : {Vertex(0), Vertex(10), Vertex(40)}) {
    while (!mesh.triangles(v).empty()) mesh.remove_triangle(mesh.triangles(v)[0]);
    mesh.remove_vertex(v);
  }
  return mesh;
}

TEST(MeshState, RoundTripIsExact) {
  const SurfaceMesh mesh = mesh_with_gaps();
  expect_same_to_the_bit(mesh, SurfaceMesh::from_state(mesh.state()));
}

TEST(MeshState, AMeshFromAStateGoesOnLikeTheOriginal) {
  SurfaceMesh original = mesh_with_gaps();
  SurfaceMesh restored = SurfaceMesh::from_state(original.state());
  for (SurfaceMesh* mesh : {&original, &restored}) {
    const Vertex a = mesh->add_vertex({7, 0, 0}), b = mesh->add_vertex({8, 0, 0}), c = mesh->add_vertex({7, 1, 0});
    mesh->add_triangle(a, b, c, {Region(1), air});
  }
  expect_same_to_the_bit(original, restored);
}

TEST(MeshState, CloneIsIndependent) {
  SurfaceMesh mesh = test::corner_tetrahedron();
  SurfaceMesh copy = mesh.clone();
  expect_same_to_the_bit(mesh, copy);
  copy.set_position(Vertex(0), {9, 9, 9});
  copy.remove_triangle(Triangle(0));
  EXPECT_EQ(mesh.position(Vertex(0)), Vec3(0, 0, 0));
  EXPECT_EQ(mesh.triangle_count(), 4U);
}

TEST(MeshState, CompactionKeepsTheSurface) {
  SurfaceMesh mesh = mesh_with_gaps();
  const std::size_t vertices = mesh.vertex_count(), edges = mesh.edge_count(), triangles = mesh.triangle_count();
  std::vector<std::array<Vec3, 3>> before;
  for (Triangle t : mesh.triangles())
    before.push_back(
        {mesh.position(mesh.vertices(t)[0]), mesh.position(mesh.vertices(t)[1]), mesh.position(mesh.vertices(t)[2])});
  mesh.compact();
  EXPECT_EQ(mesh.vertex_slots(), vertices);
  EXPECT_EQ(mesh.edge_slots(), edges);
  ASSERT_EQ(mesh.triangle_slots(), triangles);
  for (std::size_t i = 0; i < triangles; ++i)
    for (int k = 0; k < 3; ++k)
      EXPECT_EQ(mesh.position(mesh.vertices(Triangle(i))[k]), before[i][k]) << "triangles keep their order";
  EXPECT_FALSE(audit(mesh, {.intersections = false, .closed_regions = false}).has(Defect::broken_incidence));
}

TEST(MeshState, ArraysOfDifferentLengthAreRefused) {
  auto state = test::corner_tetrahedron().state();
  state.labels.pop_back();
  EXPECT_THROW(SurfaceMesh::from_state(state), MeshError);
}

TEST(MeshState, ReferencesToElementsThatDoNotExistAreRefused) {
  const auto good = test::corner_tetrahedron().state();
  auto state = good;
  state.triangle_vertices[2][1] = Vertex(40);
  EXPECT_THROW(SurfaceMesh::from_state(state), MeshError);
  state = good;
  state.edge_triangles[0].push_back(Triangle(40));
  EXPECT_THROW(SurfaceMesh::from_state(state), MeshError);
  state = good;
  state.vertex_edges[3][0] = Edge(40);
  EXPECT_THROW(SurfaceMesh::from_state(state), MeshError);
}

// Builds from a tampered state of a tetrahedron that also has gaps; the message of the refusal.
template <class Change>
std::string refusal(Change&& change) {
  SurfaceMesh mesh = test::corner_tetrahedron();
  test::add_corner_tetrahedron(mesh, 0.5, {4, 0, 0}, Region(2), air);
  for (std::size_t t = 4; t < 8; ++t) mesh.remove_triangle(Triangle(t));
  mesh.remove_vertex(Vertex(5));
  mesh.remove_vertex(Vertex(7));
  auto state = mesh.state();
  change(state);
  try {
    (void)SurfaceMesh::from_state(state);
  } catch (const MeshError& error) {
    return error.what();
  }
  return "";
}

using State = SurfaceMesh::State;

void expect_refusal(const std::string& part, const std::function<void(State&)>& change) {
  const std::string message = refusal(change);
  EXPECT_NE(message.find(part), std::string::npos) << "'" << part << "' is not in '" << message << "'";
}

TEST(MeshState, WithGapsAndIsolatedVerticesIsAMesh) {
  EXPECT_EQ(refusal([](State&) {}), "");
}

// Each of them was accepted once, and a later walk over the mesh ran out of an array.
TEST(MeshState, LinksThatContradictEachOtherAreRefusedInTheAuditsWords) {
  const std::string broken = "broken incidence: ";
  expect_refusal(broken, [](State& s) { std::swap(s.triangle_vertices[0], s.triangle_vertices[1]); });
  expect_refusal(broken, [](State& s) { s.triangle_vertices[0][1] = s.triangle_vertices[0][0]; });
  expect_refusal(broken, [](State& s) { std::swap(s.triangle_edges[1][0], s.triangle_edges[1][1]); });
  expect_refusal(broken, [](State& s) { s.edge_vertices[0] = s.edge_vertices[1]; });
  expect_refusal(broken, [](State& s) { s.edge_triangles[2].pop_back(); });
  expect_refusal(broken, [](State& s) { s.edge_triangles[2].push_back(s.edge_triangles[2][0]); });
  expect_refusal(broken, [](State& s) { s.vertex_triangles[1].pop_back(); });
  expect_refusal(broken, [](State& s) { s.vertex_triangles[1].push_back(s.vertex_triangles[1][0]); });
  expect_refusal(broken, [](State& s) { s.vertex_edges[3].clear(); });
  expect_refusal(broken, [](State& s) { s.vertex_edges[3][0] = s.vertex_edges[3][1]; });
}

TEST(MeshState, LabelsAndCoordinatesThatNoFilmHasAreRefused) {
  expect_refusal("bad labels", [](State& s) { s.labels[0] = {air, air}; });
  expect_refusal("bad labels", [](State& s) { s.labels[0].p = Region(); });
  expect_refusal("not finite", [](State& s) { s.positions[2].y() = std::nan(""); });
}

TEST(MeshState, FreeSlotsAreThoseThatAreNotInUse) {
  expect_refusal("vertex 5 is neither in use nor free", [](State& s) {
    auto free = s.vertices.free();
    std::erase(free, 5U);
    s.vertices = SlotPool(s.vertices.alive(), free);
  });
  expect_refusal("edge 0 is free, and in use", [](State& s) {
    auto free = s.edges.free();
    free.push_back(0);
    s.edges = SlotPool(s.edges.alive(), free);
  });
  expect_refusal("twice free", [](State& s) {
    auto free = s.triangles.free();
    free[0] = free[1];
    s.triangles = SlotPool(s.triangles.alive(), free);
  });
  expect_refusal("triangle 99 is free", [](State& s) { s.triangles = SlotPool(s.triangles.alive(), {99}); });
  expect_refusal("vertex 5 is not in use, and has neighbours",
                 [](State& s) { s.vertex_triangles[5].push_back(Triangle(0)); });
  expect_refusal("has neighbours", [](State& s) { s.edge_triangles[s.edges.free()[0]].push_back(Triangle(0)); });
}

// std::out_of_range once.
TEST(MeshState, InJsonATriangleHasThreeCorners) {
  const nlohmann::json whole = to_json(test::corner_tetrahedron().state());
  const auto refused = [](const nlohmann::json& state) {
    try {
      (void)mesh_state_from_json(state);
    } catch (const base::Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  for (std::uint32_t corners : {0U, 2U, 4U}) {
    nlohmann::json damaged = whole;
    std::vector<std::uint8_t> lengths = damaged["triangle_vertices"][0].get_binary();
    lengths[0] = static_cast<std::uint8_t>(corners);
    damaged["triangle_vertices"][0] = nlohmann::json::binary(lengths);
    EXPECT_NE(refused(damaged).find("surface.triangle_vertices has " + std::to_string(corners) + " entries"),
              std::string::npos)
        << refused(damaged);
  }
  nlohmann::json damaged = whole;
  damaged["labels"] = 3;
  EXPECT_EQ(refused(damaged), "surface.labels is not binary data");
  damaged.erase("labels");
  EXPECT_EQ(refused(damaged), "surface has no 'labels'");
}

TEST(MeshState, HoldsAreOfThreeCoordinates) {
  SurfaceMesh mesh = test::corner_tetrahedron();
  const auto held = mesh.add_vertex_attribute<Hold>("hold", carry::copy, Hold::x);
  nlohmann::json state = to_json(mesh.state());
  state["vertex_attributes"]["hold"]["bytes"] = nlohmann::json::binary({1, 2, 4, 8});
  SurfaceMesh read = SurfaceMesh::from_state(mesh_state_from_json(state));
  EXPECT_THROW(read.add_vertex_attribute<Hold>("hold", carry::copy, Hold::none), MeshError);
}

}  // namespace
}  // namespace lostopos
