#include "FoamSim/scenes/shapes/exact_double_bubble.h"

#include <gtest/gtest.h>

#include <cmath>

#include "Base/error.h"
#include "LosTopos/mesh/audit.h"
#include "LosTopos/mesh/measures.h"

namespace foamsim {
namespace {

using lostopos::SurfaceMesh;

double volume_of(const SurfaceMesh& mesh, std::size_t region) {
  return lostopos::region_volumes(mesh).at(region).volume;
}

TEST(ExactDoubleBubble, HasVolumesAndAreaOfItsEquilibriumUpToSecondOrder) {
  for (const auto& [v0, v1] : {std::pair{1.0, 1.0}, {1.0, 2.0}, {3.0, 1.0}}) {
    const DoubleBubbleEquilibrium e = double_bubble_equilibrium(v0, v1);
    double errors[2][3];
    for (int i = 0; i < 2; ++i) {
      const SurfaceMesh mesh = exact_double_bubble(e, 24L << i);
      EXPECT_EQ(lostopos::audit(mesh).text(), "clean");
      EXPECT_EQ(lostopos::open_edge_count(mesh), 0U);
      EXPECT_EQ(lostopos::junction_edge_count(mesh), static_cast<std::size_t>(24 << i));
      errors[i][0] = std::abs(volume_of(mesh, 1) / v0 - 1);
      errors[i][1] = std::abs(volume_of(mesh, 2) / v1 - 1);
      errors[i][2] = std::abs(lostopos::total_area(mesh) / e.total_area() - 1);
    }
    for (int k = 0; k < 3; ++k) {
      EXPECT_LT(errors[1][k], 0.01);
      EXPECT_GT(errors[0][k] / errors[1][k], 3) << v0 << ' ' << v1 << ' ' << k;
    }
  }
}

TEST(ExactDoubleBubble, HasEveryVertexOnItsSpheres) {
  const DoubleBubbleEquilibrium e = double_bubble_equilibrium(1, 2);
  const SurfaceMesh mesh = exact_double_bubble(e, 16);
  const double centres[2] = {-e.outer[0].radius * -std::cos(e.outer[0].polar_angle),
                             e.outer[1].radius * -std::cos(e.outer[1].polar_angle)};
  for (lostopos::Triangle t : mesh.triangles()) {
    const auto labels = mesh.labels(t);
    for (lostopos::Vertex v : mesh.vertices(t)) {
      const lostopos::Vec3& x = mesh.position(v);
      if (labels.has(lostopos::air)) {
        const int side = labels.has(lostopos::Region(2)) ? 1 : 0;
        EXPECT_NEAR((x - lostopos::Vec3(centres[side], 0, 0)).norm(), e.outer[side].radius, 1e-12);
      } else {
        const double centre = -e.wall.radius * std::cos(e.wall.polar_angle);
        EXPECT_NEAR((x - lostopos::Vec3(centre, 0, 0)).norm(), e.wall.radius, 1e-11);
      }
    }
  }
}

TEST(ExactDoubleBubble, NeedsSixSegments) {
  EXPECT_THROW(exact_double_bubble(double_bubble_equilibrium(1, 1), 5), base::InputError);
}

}  // namespace
}  // namespace foamsim
