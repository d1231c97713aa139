#include "FoamSim/effects/damping.h"

#include <gtest/gtest.h>

#include <cmath>

#include "FoamSim/scenes/shapes/double_bubble.h"

namespace foamsim {
namespace {

using lostopos::SurfaceMesh;
using lostopos::Vertex;

class DampingTest : public testing::Test {
 protected:
  DampingTest() {
    geometry.update(mesh);
    double value = 1;
    for (Vertex v : mesh.vertices())
      for (PairCirculation& held : circulation.at(v)) held.value = value += 0.25;
  }

  std::vector<double> values() const {
    std::vector<double> result;
    for (Vertex v : mesh.vertices())
      for (const PairCirculation& held : circulation.at(v)) result.push_back(held.value);
    return result;
  }

  SurfaceMesh mesh = double_bubble(8);
  SurfaceGeometry geometry;
  CirculationField circulation{mesh};
};

TEST_F(DampingTest, MultipliesEveryPairByTheFactorToThePowerOfDt) {
  const auto before = values();
  Damping(0.3).update_circulation({mesh, geometry, 0, 0.02}, circulation);
  const auto after = values();
  for (std::size_t i = 0; i < before.size(); ++i) EXPECT_EQ(after[i], before[i] * std::pow(0.3, 0.02));
}

TEST_F(DampingTest, DependsOnTheTimeNotOnTheNumberOfSteps) {
  const auto before = values();
  Damping damping(0.7);
  for (int i = 0; i < 64; ++i) damping.update_circulation({mesh, geometry, 0, 2.0 / 64}, circulation);
  const auto after = values();
  for (std::size_t i = 0; i < before.size(); ++i) EXPECT_NEAR(after[i] / before[i], 0.49, 1e-14);
}

TEST_F(DampingTest, ActsInStepsThatBeginAtItsTimeOrLater) {
  Damping damping(0.5, 3);
  const auto before = values();
  damping.update_circulation({mesh, geometry, 2.5, 1}, circulation);
  EXPECT_EQ(values(), before);
  damping.update_circulation({mesh, geometry, 3, 1}, circulation);
  EXPECT_EQ(values().back(), before.back() / 2);
}

TEST_F(DampingTest, OfOneIsNone) {
  const auto before = values();
  Damping(1).update_circulation({mesh, geometry, 0, 0.02}, circulation);
  EXPECT_EQ(values(), before);
}

}  // namespace
}  // namespace foamsim
