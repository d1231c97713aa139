// A caller hears of a run that memory may become short for, whether it starts or goes on.
#include <gtest/gtest.h>

#include "FoamSim/run/run.h"
#include "tests/support/scratch_folder.h"

namespace foamsim {
namespace {

using ::test::ScratchFolder;

bool is_said_to_be_large(const Scene& scene, const RunSettings& settings) {
  bool large = false;
  RunHooks hooks;
  hooks.large = [&large] { large = true; };
  run_scene(scene, settings, hooks);
  return large;
}

TEST(LargeRun, IsOneThatTakesOverHalfOfItsLimit) {
  const ScratchFolder scratch;
  Scene scene = built_in_scene("doublebubble");
  scene.options.set("n", 8L, "test");
  RunSettings settings;
  settings.out = scratch.path() / "roomy";
  settings.stop.steps = 1;
  scene.options.set("memory_limit", 1.0, "test");
  EXPECT_FALSE(is_said_to_be_large(scene, settings));
  settings.out = scratch.path() / "tight";
  scene.options.set("memory_limit", 0.03, "test");  // the program alone takes two thirds of it
  EXPECT_TRUE(is_said_to_be_large(scene, settings));

  RunSettings resumed;
  resumed.stop.steps = 2;
  resumed.resume = scratch.path() / "roomy";
  EXPECT_FALSE(is_said_to_be_large(built_in_scene("sphere"), resumed));
  resumed.resume = scratch.path() / "tight";
  EXPECT_TRUE(is_said_to_be_large(built_in_scene("sphere"), resumed));
}

}  // namespace
}  // namespace foamsim
