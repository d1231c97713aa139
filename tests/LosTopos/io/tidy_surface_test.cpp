#include "LosTopos/io/tidy_surface.h"

#include <gtest/gtest.h>

#include "LosTopos/mesh/audit.h"
#include "LosTopos/mesh/measures.h"
#include "LosTopos/shapes/solids.h"
#include "tests/support/sample_meshes.h"

namespace lostopos {
namespace {

void turn(SurfaceData& data) {
  for (Labels& labels : data.labels) labels = labels.flipped();
}

TEST(TidySurface, LeavesWhatIsSound) {
  const SurfaceData sound = from_mesh(icosphere(1));
  SurfaceData data = sound;
  EXPECT_TRUE(tidy_surface(data).empty());
  EXPECT_EQ(data, sound);
  data = from_mesh(test::open_cylinder(1, 8, 3, 0.5));  // an open film has no inside
  turn(data);
  const SurfaceData open = data;
  EXPECT_TRUE(tidy_surface(data).empty());
  EXPECT_EQ(data, open);
}

TEST(TidySurface, DropsVerticesThatNoTriangleUses) {
  SurfaceData data = from_mesh(icosphere(0));
  const SurfaceData sound = data;
  data.positions.insert(data.positions.begin() + 3, {{9, 9, 9}, {8, 8, 8}});
  for (auto& triangle : data.triangles)
    for (std::uint32_t& corner : triangle) corner += corner >= 3 ? 2 : 0;
  data.held = {{4, {8, 8, 8}}, {7, data.positions[7]}};
  PairArray circulation{"circulation", {0}, {}};
  for (std::size_t v = 0; v < data.positions.size(); ++v) {
    circulation.values.push_back({air, Region(1), static_cast<double>(v)});
    circulation.offsets.push_back(v + 1);
  }
  data.pair_arrays.push_back(circulation);
  data.vertex_arrays.push_back({"place", 3, {}});
  for (const Vec3& x : data.positions)
    data.vertex_arrays[0].values.insert(data.vertex_arrays[0].values.end(), {x.x(), x.y(), x.z()});

  const std::vector<std::string> notes = tidy_surface(data);
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_NE(notes[0].find("2 vertices that no triangle uses"), std::string::npos) << notes[0];
  EXPECT_NO_THROW(validate(data));
  EXPECT_EQ(data.positions, sound.positions);
  EXPECT_EQ(data.triangles, sound.triangles);
  ASSERT_EQ(data.held.size(), 1u);
  EXPECT_EQ(data.held[0].vertex, 5u);
  EXPECT_EQ(data.pair_arrays[0].at(2)[0].value, 2);
  EXPECT_EQ(data.pair_arrays[0].at(3)[0].value, 5);
  EXPECT_EQ(data.vertex_arrays[0].values[9], data.positions[3].x());
}

TEST(TidySurface, TurnsWhatIsInsideOut) {
  SurfaceData data = from_mesh(icosphere(1));
  turn(data);
  EXPECT_EQ(tidy_surface(data).size(), 1u);
  EXPECT_EQ(audit(to_mesh(data)).text(), "clean");
  EXPECT_GT(region_volumes(to_mesh(data))[1].volume, 0);
  EXPECT_TRUE(tidy_surface(data).empty());
}

// Turned, it is no better: one of two bubbles is wrong either way.
TEST(TidySurface, LeavesWhatTurningDoesNotCure) {
  SurfaceMesh mesh;
  test::add_corner_tetrahedron(mesh, 1, {0, 0, 0}, Region(1), air);
  test::add_corner_tetrahedron(mesh, 1, {3, 0, 0}, air, Region(1));
  SurfaceData data = from_mesh(mesh);
  const SurfaceData before = data;
  EXPECT_TRUE(tidy_surface(data).empty());
  EXPECT_EQ(data, before);
  EXPECT_FALSE(audit(to_mesh(data)).clean());
}

}  // namespace
}  // namespace lostopos
