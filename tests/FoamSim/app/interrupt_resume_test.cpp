#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "program.h"
#include "tables.h"

namespace foamsim::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

TEST(InterruptedRun, FinishesTheStepAndSaysSo) {
  const ScratchFolder scratch;
  const ProgramResult result = run_foamsim("run doublebubble --set n=24 --time 1e6 --out " + (scratch / "run"),
                                           "timeout --foreground --preserve-status -s INT 2");
  EXPECT_EQ(result.exit_code, 130) << result.error;
  const json run = json::parse(read_file(scratch / "run/run.json"));
  EXPECT_EQ(run["ended"], "interrupted");
  const fs::path last = scratch.path() / "run/frames" / run["last_frame"].get<std::string>();
  EXPECT_EQ(run_foamsim("inspect " + last.string()).exit_code, 0);
}

TEST(InterruptedRun, OfEverySignalSavesAndSaysHowToGoOn) {
  for (const auto& [signal, code] : {std::pair{"TERM", 143}, {"HUP", 129}, {"INT", 130}}) {
    const ScratchFolder scratch;
    const ProgramResult result = run_foamsim("run doublebubble --steps 1000000 --out " + (scratch / "run"),
                                             std::string("timeout --foreground --preserve-status -s ") + signal + " 1");
    EXPECT_EQ(result.exit_code, code) << result.error;
    EXPECT_EQ(json::parse(read_file(scratch / "run/run.json"))["ended"], "interrupted") << signal;
    EXPECT_TRUE(fs::exists(scratch.path() / "run/checkpoint.cbor")) << signal;
    EXPECT_NE(
        result.out.find("to go on: foamsim run --resume " + (scratch / "run/checkpoint.cbor") + " --steps 1000000\n"),
        std::string::npos)
        << result.out;
  }
}

// The first step takes minutes: three spheres grow by more than their size, and are refined meanwhile.
TEST(InterruptedRun, EndsWithinAStepWithTheOneBefore) {
  const ScratchFolder scratch;
  const ProgramResult result =
      run_foamsim("run foaminit --set n=3 --set dt=1 --set resolution=0.01 --out " + (scratch / "run"),
                  "timeout --foreground --preserve-status -s TERM 2");
  EXPECT_EQ(result.exit_code, 143) << result.error;
  const json run = json::parse(read_file(scratch / "run/run.json"));
  EXPECT_EQ(run["ended"], "interrupted");
  EXPECT_EQ(run["last_step"], 0);
  EXPECT_TRUE(fs::exists(scratch.path() / "run/checkpoint.cbor"));
}

TEST(InterruptedRun, CanBeResumedToTheSameBits) {
  const ScratchFolder scratch;
  const std::string scene = "run doublebubble --set frame_every=7 --set vtp=true";
  ASSERT_EQ(run_foamsim(scene + " --steps 40 --out " + (scratch / "whole")).exit_code, 0);
  ASSERT_EQ(run_foamsim(scene + " --steps 23 --out " + (scratch / "parts")).exit_code, 0);
  // In the same folder the tables go on; elsewhere a new run begins.
  ASSERT_EQ(run_foamsim("run --resume " + (scratch / "parts/checkpoint.cbor") + " --steps 40").exit_code, 0);
  EXPECT_EQ(read_file(scratch / "parts/frames/frame_000040.ply"), read_file(scratch / "whole/frames/frame_000040.ply"));
  EXPECT_EQ(without_seconds(read_file(scratch / "parts/metrics.csv")),
            without_seconds(read_file(scratch / "whole/metrics.csv")));
  EXPECT_EQ(read_file(scratch / "parts/volumes.csv"), read_file(scratch / "whole/volumes.csv"));
}

TEST(InterruptedRun, WritesCheckpointsAtTheAskedInterval) {
  const ScratchFolder scratch;
  // Killed without a chance to save: what the last checkpoint holds is not lost.
  run_foamsim("run doublebubble --set checkpoint_every=5 --time 1e6 --out " + (scratch / "run"), "timeout -s KILL 2");
  ASSERT_TRUE(fs::exists(scratch.path() / "run/checkpoint.cbor"));
  EXPECT_EQ(
      run_foamsim("run --resume " + (scratch / "run/checkpoint.cbor") + " --time 0.05 --out " + (scratch / "more"))
          .exit_code,
      0);
}

}  // namespace
}  // namespace foamsim::test
