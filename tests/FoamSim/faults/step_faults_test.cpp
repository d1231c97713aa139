// The n-th step of a run fails, by what an effect throws: the step is undone, the run ends in words with exit code 3,
// and goes on to the bits of a run whose steps did not fail.
#include <gtest/gtest.h>

#include <algorithm>
#include <new>

#include "FoamSim/app/run_program.h"
#include "LosTopos/error.h"
#include "tests/FoamSim/app/same_run.h"

namespace foamsim::test {
namespace {

using ::test::ScratchFolder;

enum class Thrown { motion, memory, foreign };

// Does nothing until as many steps as asked for have begun in this process.
class FailingEffect final : public Effect {
 public:
  FailingEffect(long fails_at, Thrown thrown) : fails_at_(fails_at), thrown_(thrown) {}
  std::string_view name() const override { return "failing"; }
  void move_vertices(const Stage&, std::span<lostopos::Vec3>) override {
    if (++calls_ != fails_at_) return;
    if (thrown_ == Thrown::motion) throw lostopos::MotionError("made to fail");
    if (thrown_ == Thrown::memory) throw std::bad_alloc();
    throw std::logic_error("made to fail");
  }

 private:
  long fails_at_, calls_ = 0;
  Thrown thrown_;
};

struct Result {
  int exit_code;
  std::string error;
};

// The program in this process, with an effect that fails at a call; 0: never.
Result run(const std::vector<std::string>& words, long fails_at, Thrown thrown) {
  auto catalogue = std::make_shared<Catalogue>(*built_in_catalogue());
  catalogue->effects.add(
      {"failing", "fails", {}, [=](const EffectSetup&) { return std::make_unique<FailingEffect>(fails_at, thrown); }});
  std::vector<std::string> arguments{"foamsim", "run", "--quiet", "--steps", "6"};
  arguments.insert(arguments.end(), words.begin(), words.end());
  std::vector<char*> argv;
  argv.reserve(arguments.size() + 1);
  for (std::string& word : arguments) argv.push_back(word.data());
  argv.push_back(nullptr);
  testing::internal::CaptureStderr();
  const int code = run_program(static_cast<int>(arguments.size()), argv.data(), catalogue);
  return {code, testing::internal::GetCapturedStderr()};
}

Result run_scene_into(const std::string& folder, long fails_at, Thrown thrown) {
  return run({"doublebubble", "--set", "n=8", "--set", "checkpoint_every=2", "--set", "frame_every=1", "--set",
              "effects=surface_tension,failing", "--force", "--out", folder},
             fails_at, thrown);
}

class StepFault : public testing::TestWithParam<Thrown> {};

TEST_P(StepFault, EndsInWordsAndGoesOnToTheSameBits) {
  const ScratchFolder scratch;
  const std::string whole = scratch / "whole", folder = scratch / "run";
  ASSERT_EQ(run_scene_into(whole, 0, GetParam()).exit_code, 0);
  int failed = 0;
  for (long n = 1; n <= 40; ++n) {
    SCOPED_TRACE(n);
    const Result result = run_scene_into(folder, n, GetParam());
    if (result.exit_code == 0) break;  // there are not so many calls
    ++failed;
    EXPECT_EQ(result.exit_code, 3) << result.error;
    EXPECT_TRUE(result.error.starts_with("foamsim: ")) << result.error;
    EXPECT_LE(std::ranges::count(result.error, '\n'), 2) << result.error;
    const bool saved = std::filesystem::exists(folder + "/checkpoint.cbor");
    const Result rest = saved ? run({"--resume", folder}, 0, GetParam()) : run_scene_into(folder, 0, GetParam());
    ASSERT_EQ(rest.exit_code, 0) << rest.error;
    expect_same_files(whole, folder);
  }
  EXPECT_GE(failed, 6);
}

std::string name_of(const testing::TestParamInfo<Thrown>& info) {
  if (info.param == Thrown::motion) return "Motion";
  return info.param == Thrown::memory ? "Memory" : "Foreign";
}

INSTANTIATE_TEST_SUITE_P(Each, StepFault, testing::Values(Thrown::motion, Thrown::memory, Thrown::foreign), name_of);

}  // namespace
}  // namespace foamsim::test
