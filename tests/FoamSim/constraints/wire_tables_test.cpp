// Wires in scene files.
#include <gtest/gtest.h>

#include <fstream>

#include "Base/error.h"
#include "FoamSim/scenes/scene.h"
#include "tests/support/scratch_folder.h"

namespace foamsim {
namespace {

Scene scene_of(const ::test::ScratchFolder& folder, const std::string& text) {
  const auto file = folder.path() / "wired.toml";
  std::ofstream(file) << text;
  return load_scene(file.string());
}

std::string refusal_of_table(const std::string& text) {
  const ::test::ScratchFolder folder;
  try {
    scene_of(folder, text);
  } catch (const base::InputError& error) {
    const std::string message = error.what();
    return message.substr(message.find("wired.toml"));
  }
  return "";
}

TEST(WireTables, BecomeTheTextsOfTheOption) {
  const ::test::ScratchFolder folder;
  const Scene scene = scene_of(folder, R"(scene = "doublebubble"
[[wire]]
vertices = [0, 7]
motion = "move 1 0 0"
from = 0.5
until = 2

[[wire]]
selection = "x < -1.4"
)");
  EXPECT_EQ(scene.options.words("wires"),
            (std::vector<std::string>{"vertices 0 7: move 1 0 0 from 0.5 until 2", "x < -1.4: still"}));
  EXPECT_EQ(scene.options.words("constraints"), std::vector<std::string>{"wire"});
}

TEST(WireTables, AreRefusedWithTheirLine) {
  const std::string begin = "scene = \"doublebubble\"\n[[wire]]\n";
  EXPECT_EQ(refusal_of_table(begin + "motion = \"still\"\n"),
            "wired.toml:2: a wire needs either vertices = [3, 4, 5] or selection = \"held and x < 0\"");
  EXPECT_EQ(refusal_of_table(begin + "vertices = [1]\nspeed = 3\n"),
            "wired.toml:4: a wire has no 'speed'; it has vertices or selection, motion, from and until");
  EXPECT_EQ(refusal_of_table(begin + "vertices = [1]\nmotion = \"spin\"\n"),
            "wired.toml:2: the motion of the wire 'vertices 1: spin' cannot be read: no motion is called 'spin'; it is "
            "'still', 'move VX VY VZ' or 'pull SPEED [along AX AY AZ]', then where wanted 'from T' and 'until T'");
  EXPECT_EQ(refusal_of_table(begin + "vertices = []\n"),
            "wired.toml:3: 'vertices' is a list of vertex numbers, not empty");
  EXPECT_EQ(refusal_of_table("scene = \"doublebubble\"\nwire = 3\n"),
            "wired.toml:2: wires are tables: begin each with [[wire]]");
}

// What nothing holds costs nothing: no constraint is made where films have no free edge.
TEST(Constraints, AreMadeOnlyWhereSomethingIsHeld) {
  EXPECT_TRUE(make_simulation(built_in_scene("doublebubble")).constraints().empty());
  EXPECT_EQ(make_simulation(built_in_scene("quadjunction-frame")).constraints().size(), 1U);
  Scene scene = built_in_scene("quadjunction-frame");
  scene.options.set_assignment("constraints=wire", "test");
  scene.options.set_assignment("wires=free-edges: still", "test");
  const Simulation simulation = make_simulation(scene);
  ASSERT_EQ(simulation.constraints().size(), 1U);
  EXPECT_EQ(simulation.constraints()[0]->name(), "wire");
  EXPECT_FALSE(simulation.options().tracker.remesh.collapse_to_held);
  EXPECT_TRUE(make_simulation(built_in_scene("quadjunction-frame")).options().tracker.remesh.collapse_to_held);
}

}  // namespace
}  // namespace foamsim
