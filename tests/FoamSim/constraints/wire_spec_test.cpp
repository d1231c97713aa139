// What is held, and how it moves, as texts.
#include "FoamSim/constraints/wire_spec.h"

#include <gtest/gtest.h>

#include "Base/error.h"
#include "tests/support/sample_meshes.h"

namespace foamsim {
namespace {

using lostopos::Hold;
using lostopos::Vec3;
using lostopos::Vertex;

std::string message_of(const auto& action) {
  try {
    action();
  } catch (const base::InputError& error) {
    return error.what();
  }
  return "";
}

// A tube along x: rings of six vertices at x = 0, 0.5, 1.
class TubeSelection : public testing::Test {
 protected:
  lostopos::SurfaceMesh tube_ = lostopos::test::open_cylinder(1, 6, 2, 0.5);
  std::vector<Hold> held_ = std::vector<Hold>(tube_.vertex_slots(), Hold::none);

  std::vector<std::uint32_t> of(const std::string& text) {
    std::vector<std::uint32_t> numbers;
    for (Vertex v : Selection(text).of(tube_, held_)) numbers.push_back(v.index());
    return numbers;
  }
};

TEST_F(TubeSelection, MeansVerticesByWhatIsHeldFreeNumberedOrWhere) {
  held_[3] = held_[14] = Hold::all;
  held_[4] = Hold::x;  // in a wall, which is no wire
  using Numbers = std::vector<std::uint32_t>;
  EXPECT_EQ(of("held"), (Numbers{3, 14}));
  EXPECT_EQ(of("held and x < 0.5"), (Numbers{3}));
  EXPECT_EQ(of("vertices 7 2"), (Numbers{2, 7}));
  EXPECT_EQ(of("free-edges and x >= 1"), (Numbers{12, 13, 14, 15, 16, 17}));
  EXPECT_EQ(of("x>0.25 and x<=0.5"), (Numbers{6, 7, 8, 9, 10, 11}));
}

TEST_F(TubeSelection, RefusesWhatMeansNothing) {
  for (const char* bad :
       {"", "helt", "held and", "and held", "x < ", "x = 0", "w < 0", "vertices", "vertices a", "x<<0"})
    EXPECT_THROW(Selection{bad}, base::InputError) << bad;
  EXPECT_THROW(of("held"), base::InputError);
  EXPECT_EQ(message_of([this] { of("x < -3"); }),
            "the selection 'x < -3' matches no vertex of the start mesh, which has 18 (0 of them marked as held)");
  EXPECT_EQ(message_of([this] { of("vertices 3 18"); }),
            "the selection 'vertices 3 18' names vertex 18, which the start mesh does not have; its vertices are 0 to "
            "17");
}

TEST(WireSpec, IsTheSameBehindItsText) {
  for (const char* text :
       {"held: still", "held and x < 0: move -0.08 0 0 until 2.5", "free-edges: pull 0.04",
        "vertices 3 4 5: pull -0.5 along 0 1 0 from 1 until 2", "held and y < -4: move 0 -0.4 0 from 5"})
    EXPECT_EQ(WireSpec(text).text(), text);
  EXPECT_EQ(WireSpec("held:pull 1 along z").motion.axis, Vec3(0, 0, 1));
  EXPECT_EQ(WireSpec("held: pull 1 along 0 3 4").motion.axis, Vec3(0, 0.6, 0.8));
}

TEST(WireSpec, MovesWhileItsTimeLasts) {
  const WireMotion motion = WireSpec("held: move 2 0 -4 from 1 until 3").motion;
  const auto between = [&motion](double start, double end) { return motion.displacement(motion.velocity, start, end); };
  EXPECT_EQ(between(0, 1), Vec3(0, 0, 0));
  EXPECT_EQ(between(0, 1.5), Vec3(1, 0, -2));
  EXPECT_EQ(between(1.5, 2), Vec3(1, 0, -2));
  EXPECT_EQ(between(2.5, 7), Vec3(1, 0, -2));
  EXPECT_EQ(between(3, 9), Vec3(0, 0, 0));
}

TEST(WireSpec, RefusesMotionsThatItDoesNotKnow) {
  for (const char* bad :
       {"held", "held:", "held: spin 3", "held: move 1 2", "held: move 1 2 x", "held: pull", "held: pull 1 along 0 0 0",
        "held: still until", "held: still for 3", "held: move 1 0 0 from 3 until 2", "held: move nan 0 0"})
    EXPECT_THROW(WireSpec{bad}, base::InputError) << bad;
  EXPECT_EQ(
      message_of([] { WireSpec("held: spin 3"); }),
      "the motion of the wire 'held: spin 3' cannot be read: no motion is called 'spin'; it is 'still', 'move VX VY "
      "VZ' or 'pull SPEED [along AX AY AZ]', then where wanted 'from T' and 'until T'");
}

}  // namespace
}  // namespace foamsim
