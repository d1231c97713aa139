// Every built-in scene for many steps: the same bits with 1, 2 and 4 threads, on every instruction set, and resumed
// from a checkpoint at a step drawn by lot. FOAMSIM_SOAK_STEPS: how many steps at most (200); FOAMSIM_SOAK_SECONDS: for
// how long each scene is run at most to find out how many steps it makes then (30).
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <random>

#include "FoamSim/scenes/scene_registry.h"
#include "FoamSim/sheet/velocity/direct_kernel.h"
#include "tests/FoamSim/app/program.h"
#include "tests/FoamSim/app/same_run.h"

namespace foamsim::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

long number_from_environment(const char* name, long otherwise) {
  const char* text = std::getenv(name);
  return text != nullptr ? std::stol(text) : otherwise;
}

std::vector<std::string> scenes() {
  std::vector<std::string> names;
  for (const SceneEntry& scene : built_in_scenes())
    if (scene.name != "load") names.push_back(scene.name);  // starts from a file
  return names;
}

bool has_fused_multiplication(const std::string& target) {
  return target.starts_with("AVX") || target.starts_with("NEON");
}

json record(const fs::path& folder) {
  return json::parse(read_file(folder / "run.json"));
}

class Soak : public testing::TestWithParam<std::string> {
 protected:
  std::string path(const std::string& name) const { return scratch_ / name; }

  ProgramResult run(const std::string& folder, long steps, const std::string& more, const std::string& before = "") {
    return run_foamsim("run " + GetParam() + " --quiet --set frame_every=1000000 --steps " + std::to_string(steps) +
                           " --out " + path(folder) + " " + more,
                       before);
  }

  // Steps that the scene makes in the time that there is for it.
  long steps_in_time() {
    const long most = number_from_environment("FOAMSIM_SOAK_STEPS", 200);
    const long seconds = number_from_environment("FOAMSIM_SOAK_SECONDS", 30);
    const ProgramResult result =
        run("probe", most, "", "timeout --foreground --preserve-status -s INT " + std::to_string(seconds));
    EXPECT_TRUE(result.exit_code == 0 || result.exit_code == 130) << result.error;
    return record(path("probe"))["last_step"].get<long>();
  }

  void expect_same_surface(const std::string& folder) {
    const auto last_frame = [&](const std::string& name) {
      return read_file(path(name) + "/frames/" + record(path(name))["last_frame"].get<std::string>());
    };
    EXPECT_TRUE(last_frame("whole") == last_frame(folder));
    for (const char* table : {"/metrics.csv", "/volumes.csv"}) {
      EXPECT_EQ(without_seconds(read_file(path("whole") + table)), without_seconds(read_file(path(folder) + table)));
    }
  }

 private:
  const ScratchFolder scratch_;
};

TEST_P(Soak, HasTheSameBitsHoweverItIsRun) {
  const long steps = steps_in_time();
  RecordProperty("steps", std::to_string(steps));
  ASSERT_GT(steps, 0) << "not one step in the time";
  ASSERT_EQ(run("whole", steps, "--threads 1").exit_code, 0);
  for (const char* threads : {"2", "4"}) {
    SCOPED_TRACE(std::string(threads) + " threads");
    ASSERT_EQ(run(threads, steps, std::string("--threads ") + threads).exit_code, 0);
    expect_same_files(path("whole"), path(threads));
  }
  // Sums by tree need fused multiplication for the same bits.
  const bool by_tree = record(path("whole"))["options"]["velocity"] != "direct";
  for (const std::string& target : simd_targets()) {
    if (by_tree && !has_fused_multiplication(target)) continue;
    SCOPED_TRACE(target);
    ASSERT_EQ(run(target, steps, "--simd " + target).exit_code, 0);
    // The work of blowing comes from sums of the conservative scheme, which need fused multiplication for the same
    // bits.
    expect_same_files(path("whole"), path(target), "effect_work");
  }
  std::seed_seq seed(GetParam().begin(), GetParam().end());
  std::mt19937 lot(seed);
  const long stop = steps > 1 ? 1 + static_cast<long>(lot() % static_cast<unsigned>(steps - 1)) : 1;
  SCOPED_TRACE("resumed at step " + std::to_string(stop));
  ASSERT_EQ(run("parts", stop, "").exit_code, 0);
  const ProgramResult resumed =
      run_foamsim("run --quiet --resume " + path("parts") + "/checkpoint.cbor --steps " + std::to_string(steps));
  ASSERT_EQ(resumed.exit_code, 0) << resumed.error;
  expect_same_surface("parts");
}

INSTANTIATE_TEST_SUITE_P(All, Soak, testing::ValuesIn(scenes()), [](const auto& info) {
  std::string name = info.param;
  std::ranges::replace(name, '-', '_');
  return name;
});

}  // namespace
}  // namespace foamsim::test
