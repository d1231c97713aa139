#include "LosTopos/topology/region_parts.h"

#include <gtest/gtest.h>

#include "LosTopos/shapes/sphere_layout.h"

namespace lostopos {
namespace {

TEST(RegionShape, CountsThePiecesOfItsBoundary) {
  const RegionShape one = region_shape(sphere_meshes({{Vec3::Zero(), 1}}, false), air);
  EXPECT_EQ(one.pieces, 1u);
  EXPECT_EQ(one.pockets, 0u);
  EXPECT_EQ(one.tunnels, 0);
  const RegionShape two = region_shape(sphere_meshes({{Vec3::Zero(), 1}, {Vec3(3, 0, 0), 1}}, false), air);
  EXPECT_EQ(two.pieces, 2u);
  EXPECT_EQ(two.pockets, 0u);
  EXPECT_EQ(two.tunnels, 0);
}

// A bubble of air within a bubble.
TEST(RegionShape, CountsPocketsOfTheAir) {
  SurfaceMesh mesh = sphere_meshes({{Vec3::Zero(), 2}, {Vec3::Zero(), 1}}, true);
  for (Triangle t : mesh.triangles())
    if (mesh.position(mesh.vertices(t)[0]).norm() < 1.5) mesh.set_labels(t, mesh.labels(t).flipped());
  const RegionShape shape = region_shape(mesh, air);
  EXPECT_EQ(shape.pieces, 1u);
  EXPECT_EQ(shape.pockets, 1u);
  EXPECT_EQ(shape.tunnels, 0);
}

}  // namespace
}  // namespace lostopos
