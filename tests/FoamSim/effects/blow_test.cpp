#include "FoamSim/effects/blow.h"

#include <gtest/gtest.h>

#include "Base/error.h"
#include "LosTopos/shapes/solids.h"

namespace foamsim {
namespace {

using lostopos::Hold;
using lostopos::Region;
using lostopos::Vertex;

// A ball, two vertices of which are held.
struct Ball {
  Ball() : mesh(lostopos::icosphere(1)), circulation(mesh), held(mesh.vertex_slots(), Hold::none) {
    geometry.update(mesh);
    held[3] = held[5] = Hold::all;
  }
  EffectStep at(double time) const { return {mesh, geometry, time, 0.1, held}; }
  double circulation_at(std::size_t v) const { return circulation.get(Vertex(v), {Region(0), Region(1)}); }
  lostopos::SurfaceMesh mesh;
  CirculationField circulation;
  SurfaceGeometry geometry;
  std::vector<Hold> held;
};

TEST(BlowTest, LowersCirculationAtTheStrawUntilItsEnd) {
  Ball ball;
  Blow blow({.rate = 4, .until = 0.3});
  blow.attach(ball.mesh);
  blow.begin(ball.at(0));
  for (int i = 0; i < 10; ++i)
    if (blow.drives(0.1 * i + 0.05)) blow.drive_circulation(ball.at(0.1 * i + 0.05), ball.circulation);
  for (Vertex v : ball.mesh.vertices())
    EXPECT_NEAR(ball.circulation_at(v.index()), v.index() == 3 || v.index() == 5 ? -4 * 0.1 * 3 : 0, 1e-12);
  EXPECT_EQ(blow.mouth(0.1).size(), ball.mesh.vertex_slots());
  EXPECT_TRUE(blow.mouth(0.3).empty());
}

TEST(BlowTest, BlowsAtTheHeldVerticesOfItsSelection) {
  Ball ball;
  Blow blow({.where = "vertices 4 5"});
  blow.attach(ball.mesh);
  blow.begin(ball.at(0));
  blow.drive_circulation(ball.at(0), ball.circulation);
  EXPECT_EQ(ball.circulation_at(3), 0);
  EXPECT_EQ(ball.circulation_at(4), 0) << "not held";
  EXPECT_LT(ball.circulation_at(5), 0);
}

TEST(BlowTest, RefusesWhatIsNotThere) {
  Ball ball;
  Blow other_region({.region = Region(2)});
  other_region.attach(ball.mesh);
  EXPECT_THROW(other_region.begin(ball.at(0)), base::InputError);
  EXPECT_THROW(Blow({.where = "somewhere"}), base::InputError);
}

TEST(BlowTest, RefusesAStrawThatIsNotHeld) {
  Ball ball;
  Blow blow({.where = "vertices 4"});
  blow.attach(ball.mesh);
  EXPECT_THROW(blow.begin(ball.at(0)), base::InputError);
}

}  // namespace
}  // namespace foamsim
