// A run that is killed (kill -9) at any time goes on to the bits of one that was not.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

#include "Base/timing/stopwatch.h"
#include "program.h"
#include "same_run.h"

namespace foamsim::test {
namespace {

namespace fs = std::filesystem;

// What a user does after a kill: goes on where there is a checkpoint, and begins anew where there is none yet.
std::string command_after_kill(const std::string& scene, const std::string& folder) {
  if (fs::exists(folder + "/checkpoint.cbor")) return "run --resume " + folder + " --steps 60 --quiet";
  return scene + " --quiet --force --out " + folder;
}

TEST(KilledRun, GoesOnToTheSameBitsAndLeavesNothingBehind) {
  constexpr int most_kills = 12;
  std::mt19937 random(15);
  std::uniform_real_distribution<double> share(0.1, 0.7);  // of the whole run's time
  const std::string scene =
      "run doublebubble --set n=12 --set vtp=true --set frame_every=7 --set checkpoint_every=3 --steps 60";
  const ScratchFolder scratch;
  const base::Stopwatch watch;
  ASSERT_EQ(run_foamsim(scene + " --quiet --out " + (scratch / "whole")).exit_code, 0);
  const double seconds = watch.seconds();
  for (int round = 0; round < 2; ++round) {
    const std::string folder = scratch / "parts" + std::to_string(round);
    int kills = 0, code = 137;
    for (; kills < most_kills && code == 137; ++kills)
      code =
          run_foamsim(command_after_kill(scene, folder), "timeout -s KILL " + std::to_string(seconds * share(random)))
              .exit_code;
    if (code != 0) code = run_foamsim(command_after_kill(scene, folder)).exit_code;
    ASSERT_EQ(code, 0);
    EXPECT_GT(kills, 1) << "it was too fast to be killed";
    expect_same_files(scratch / "whole", folder);
  }
}

// Killed behind the last checkpoint, between the last frame's .ply and its .vtp, or before that one is in surface.pvd.
TEST(KilledRun, WritesAFrameAnewThatWasCutShort) {
  const ScratchFolder scratch;
  const std::string steps = " --steps 4 --quiet";
  const std::string scene = "run doublebubble --set n=8 --set vtp=true --set frame_every=3 --set checkpoint_every=2";
  ASSERT_EQ(run_foamsim(scene + steps + " --out " + (scratch / "whole")).exit_code, 0);
  for (const bool has_vtp : {false, true}) {
    const std::string folder = scratch / (has_vtp ? "unlisted" : "without");
    fs::copy(scratch / "whole", folder, fs::copy_options::recursive);
    if (!has_vtp) fs::remove(folder + "/vtp/frame_000004.vtp");
    std::string list = read_file(folder + "/surface.pvd");
    const std::size_t entry = list.rfind("<DataSet");
    ASSERT_NE(list.find("frame_000004.vtp", entry), std::string::npos);
    const std::size_t begin = list.rfind('\n', entry) + 1;
    list.erase(begin, list.find('\n', entry) + 1 - begin);
    std::ofstream(folder + "/surface.pvd") << list;
    std::string command = "run --resume ";
    command.append(folder).append(steps);
    ASSERT_EQ(run_foamsim(command).exit_code, 0);
    expect_same_files(scratch / "whole", folder);
  }
}

// run.json tells what it was, from the start on, also of one that nobody saw end.
TEST(KilledRun, IsToldByItsFolder) {
  const ScratchFolder scratch;
  const std::string folder = scratch / "run";
  run_foamsim("run doublebubble --set n=12 --steps 1000000 --out " + folder, "timeout -s KILL 1");
  const auto run = nlohmann::json::parse(read_file(folder + "/run.json"));
  EXPECT_EQ(run["ended"], "running");
  EXPECT_EQ(run["scene"], "doublebubble");
  EXPECT_EQ(run["options"]["n"], 12);
  EXPECT_NE(run["command"].get<std::string>().find("--set n=12"), std::string::npos);
  const ProgramResult early = run_foamsim("run --resume " + folder);
  EXPECT_EQ(early.exit_code, 2);
  EXPECT_NE(early.error.find("before its first checkpoint"), std::string::npos) << early.error;
}

TEST(KilledRun, HasACheckpointByWallTime) {
  const ScratchFolder scratch;
  const std::string folder = scratch / "run";
  run_foamsim("run doublebubble --set n=12 --set checkpoint_seconds=0.3 --steps 1000000 --out " + folder,
              "timeout -s KILL 2");
  EXPECT_EQ(run_foamsim("run --resume " + folder + " --steps 1").exit_code, 0);
}

}  // namespace
}  // namespace foamsim::test
