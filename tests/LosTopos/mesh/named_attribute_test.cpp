// Attributes with names: the state of the mesh, and what waits for an attribute of its name.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "LosTopos/error.h"
#include "LosTopos/mesh/hold.h"
#include "LosTopos/mesh/state_json.h"
#include "LosTopos/mesh/surface_mesh.h"
#include "tests/support/film_meshes.h"
#include "tests/support/sample_meshes.h"

namespace lostopos {
namespace {

// One of every kind of value, each different in every slot.
struct Data {
  explicit Data(SurfaceMesh& mesh)
      : thickness(mesh.add_vertex_attribute<double>("thickness", carry::conserve, 0.5)),
        velocity(mesh.add_vertex_attribute<Vec3>("velocity", carry::interpolate, Vec3::Zero())),
        hold(mesh.add_vertex_attribute<Hold>("hold", carry::copy, Hold::none)),
        age(mesh.add_edge_attribute<int>("age", carry::copy, -1)),
        colour(mesh.add_triangle_attribute<std::uint8_t>("colour", carry::copy)) {}
  void fill() {
    for (std::size_t i = 0; i < thickness.slots().size(); ++i) {
      const Vertex v(i);
      thickness[v] = 1 / (1.0 + v.index());
      velocity[v] = Vec3(v.index(), 0.1, -2);
      hold[v] = v.index() % 3 == 0 ? Hold::x | Hold::z : Hold::none;
    }
    for (std::size_t i = 0; i < age.slots().size(); ++i) age.slots()[i] = static_cast<int>(i) - 7;
    for (std::size_t i = 0; i < colour.slots().size(); ++i) colour.slots()[i] = static_cast<std::uint8_t>(i);
  }
  bool same_as(const Data& other) const {
    return std::ranges::equal(thickness.slots(), other.thickness.slots()) &&
           std::ranges::equal(velocity.slots(), other.velocity.slots()) &&
           std::ranges::equal(hold.slots(), other.hold.slots()) && std::ranges::equal(age.slots(), other.age.slots()) &&
           std::ranges::equal(colour.slots(), other.colour.slots());
  }
  VertexAttribute<double> thickness;
  VertexAttribute<Vec3> velocity;
  VertexAttribute<Hold> hold;
  EdgeAttribute<int> age;
  TriangleAttribute<std::uint8_t> colour;
};

void change_much(SurfaceMesh& mesh) {
  for (std::size_t i = 0; i < mesh.triangle_slots(); i += 2) mesh.remove_triangle(Triangle(i));
  for (std::size_t i = 0; i < mesh.vertex_slots(); ++i)
    if (mesh.triangles(Vertex(i)).empty()) mesh.remove_vertex(Vertex(i));
  const Vertex added = mesh.add_vertex({9, 9, 9});
  mesh.add_vertex({9, 9, 8});
  for (Vertex v : mesh.vertices()) mesh.set_position(v, 2 * mesh.position(v));
  mesh.remove_vertex(added);
  mesh.compact();
}

TEST(NamedAttribute, HasANameOfItsOwn) {
  SurfaceMesh mesh = test::corner_tetrahedron();
  const auto first = mesh.add_vertex_attribute<double>("thickness", carry::interpolate);
  EXPECT_THROW(mesh.add_vertex_attribute<double>("thickness", carry::interpolate), MeshError);
  EXPECT_NO_THROW(mesh.add_triangle_attribute<double>("thickness", carry::copy)) << "of another kind of element";
  EXPECT_NO_THROW(mesh.add_vertex_attribute<double>("width", carry::interpolate));
}

TEST(NamedAttribute, IsRestoredInPlaceToTheBitAfterAnyChange) {
  SurfaceMesh mesh = test::analytic_double_bubble(1, 12);
  Data data(mesh);
  data.fill();
  SurfaceMesh copy = mesh.clone();
  Data expected(copy);
  expected.fill();
  SurfaceMesh::State state;
  for (int round = 0; round < 2; ++round) {  // into memory that is used again
    mesh.save(state);
    change_much(mesh);
    data.thickness.slots()[0] = 17;
    mesh.restore(state);
    EXPECT_TRUE(test::same_bits(state, mesh.state()));
    EXPECT_TRUE(data.same_as(expected));
  }
  const Vertex added = mesh.add_vertex({1, 2, 3});
  EXPECT_EQ(data.thickness[added], 0.5) << "it goes on as before";
}

TEST(NamedAttribute, ThatAStateDoesNotKnowIsInitialAfterwards) {
  SurfaceMesh mesh = test::corner_tetrahedron();
  const auto before = mesh.state();
  auto thickness = mesh.add_vertex_attribute<double>("thickness", carry::interpolate, 3);
  thickness[Vertex(1)] = 4;
  mesh.restore(before);
  EXPECT_EQ(thickness[Vertex(1)], 3);
}

TEST(NamedAttribute, WaitsInAMeshForTheOneOfItsName) {
  SurfaceMesh mesh = test::analytic_double_bubble(1, 12);
  Data data(mesh);
  data.fill();
  SurfaceMesh other = SurfaceMesh::from_state(mesh.state());
  EXPECT_TRUE(Data(other).same_as(data));
  SurfaceMesh again = SurfaceMesh::from_state(SurfaceMesh::from_state(mesh.state()).state());
  EXPECT_TRUE(Data(again).same_as(data)) << "what waits is part of the state";
  SurfaceMesh wrong = SurfaceMesh::from_state(mesh.state());
  EXPECT_THROW(wrong.add_vertex_attribute<int>("thickness", carry::copy), MeshError);
  SurfaceMesh cloned = mesh.clone();
  EXPECT_EQ(cloned.add_vertex_attribute<double>("thickness", carry::interpolate, 2)[Vertex(3)], 2);
}

TEST(NamedAttribute, CanLeaveItsValuesForTheNext) {
  SurfaceMesh mesh = test::corner_tetrahedron();
  auto thickness = mesh.add_vertex_attribute<double>("thickness", carry::interpolate);
  thickness[Vertex(2)] = 6;
  std::move(thickness).leave();
  SurfaceMesh moved = std::move(mesh);
  EXPECT_EQ(moved.add_vertex_attribute<double>("thickness", carry::copy)[Vertex(2)], 6);
  EXPECT_EQ(moved.add_vertex_attribute<double>("thickness", carry::copy)[Vertex(2)], 0) << "taken, and gone with it";
  auto number = moved.add_vertex_attribute<int>(1);
  EXPECT_THROW(std::move(number).leave(), MeshError);
}

TEST(NamedAttribute, GoesThroughJsonByItsName) {
  SurfaceMesh mesh = test::analytic_double_bubble(1, 12);
  mesh.remove_triangle(Triangle(5));
  Data data(mesh);
  data.fill();
  const auto bytes = nlohmann::json::to_cbor(to_json(mesh.state()));
  const auto state = mesh_state_from_json(nlohmann::json::from_cbor(bytes));
  EXPECT_TRUE(test::same_bits(state, mesh.state()));
  SurfaceMesh read = SurfaceMesh::from_state(state);
  EXPECT_TRUE(Data(read).same_as(data));
  SurfaceMesh passed_on = SurfaceMesh::from_state(state);
  const auto again = nlohmann::json::to_cbor(to_json(passed_on.state()));
  EXPECT_EQ(again, bytes) << "unread values are written as they came";
}

TEST(NamedAttribute, DamagedValuesAreRefused) {
  SurfaceMesh mesh = test::corner_tetrahedron();
  const auto thickness = mesh.add_vertex_attribute<double>("thickness", carry::interpolate);
  const nlohmann::json whole = to_json(mesh.state());
  nlohmann::json damaged = whole;
  damaged["vertex_attributes"]["thickness"]["bytes"] = nlohmann::json::binary(std::vector<std::uint8_t>(5));
  SurfaceMesh read = SurfaceMesh::from_state(mesh_state_from_json(damaged));
  EXPECT_THROW(read.add_vertex_attribute<double>("thickness", carry::interpolate), MeshError);
  damaged = whole;
  damaged["vertex_attributes"]["thickness"]["count"] = 3;
  EXPECT_THROW(mesh_state_from_json(damaged), MeshError);
}

}  // namespace
}  // namespace lostopos
