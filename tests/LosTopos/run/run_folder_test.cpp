// What a run leaves in its folder.
#include <gtest/gtest.h>

#include <fstream>

#include "LosTopos/io/pvd.h"
#include "tests/LosTopos/run/fake_motion.h"
#include "tests/support/run_program.h"
#include "tests/support/scratch_folder.h"

namespace lostopos::run {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::FakeMotion;
using ::test::read_file;
using ::test::ScratchFolder;

Output output_in(const fs::path& folder) {
  Output output;
  output.folder = folder;
  output.frame_every = 3;
  output.checkpoint_every = 4;
  output.vtp = true;
  output.checkpoint = {"fake", 1};
  output.describe = [](nlohmann::ordered_json& run) { run["scene"] = "fake"; };
  return output;
}

std::vector<std::string> frames_listed(const fs::path& folder) {
  std::vector<std::string> files;
  for (const PvdFrame& frame : read_pvd(folder / "surface.pvd")) files.push_back(frame.file);
  return files;
}

// Runs one from its checkpoint, in the same folder.
Outcome go_on(const fs::path& folder, long last_step) {
  FakeMotion motion = FakeMotion::resumed(folder / "checkpoint.cbor");
  Output output = output_in(folder);
  output.go_on = true;
  return run_motion(motion, {.last_step = last_step}, output);
}

TEST(RunFolder, HoldsTheFramesTablesAndCheckpointOfARun) {
  const ScratchFolder scratch;
  FakeMotion motion;
  const Outcome outcome = run_motion(motion, {.last_step = 7}, output_in(scratch.path() / "run"));
  EXPECT_EQ(read_file(scratch / "run/metrics.csv").substr(0, 10), "step,time\n");
  for (const char* frame : {"000000", "000003", "000006", "000007"}) {
    EXPECT_TRUE(fs::exists(scratch.path() / "run/frames" / ("frame_" + std::string(frame) + ".ply"))) << frame;
    EXPECT_TRUE(fs::exists(scratch.path() / "run/vtp" / ("frame_" + std::string(frame) + ".vtp"))) << frame;
  }
  EXPECT_EQ(frames_listed(scratch.path() / "run").size(), 4u);
  EXPECT_EQ(FakeMotion::resumed(outcome.checkpoint).steps(), 7);
  const json run = json::parse(read_file(scratch / "run/run.json"));
  EXPECT_EQ(run["scene"], "fake");
  EXPECT_EQ(run["ended"], "finished");
  EXPECT_EQ(run["last_step"], 7);
  EXPECT_EQ(run["height"], 7);
  EXPECT_EQ(run["stage_seconds"]["rise"], 7 * 0.25);
  EXPECT_EQ(run["last_frame"], "frame_000007.ply");
}

// Under the names of the reference programs, by their frames: here two a step.
TEST(RunFolder, HoldsMeshesForTheReferencePrograms) {
  const ScratchFolder scratch;
  FakeMotion motion;
  Output output = output_in(scratch.path() / "run");
  output.rec_every = 2;
  output.obj_every = 3;
  output.reference_frames = 2;
  run_motion(motion, {.last_step = 5}, output);
  for (const char* frame : {"000000", "000004", "000008"}) {
    const SurfaceData read = read_rec(scratch.path() / "run/rec" / ("mesh" + std::string(frame) + ".rec"));
    EXPECT_EQ(read.positions.at(0).z(), std::stod(frame) / 2);
    EXPECT_EQ(read.triangles.size(), 1u);
  }
  EXPECT_FALSE(fs::exists(scratch.path() / "run/rec/mesh000010.rec"));
  EXPECT_TRUE(fs::exists(scratch.path() / "run/obj/mesh000006.obj"));
  EXPECT_NE(read_file(scratch / "run/obj/mesh000000.obj").find("vn 0 0 1\n"), std::string::npos);
  EXPECT_NE(read_file(scratch / "run/obj/mesh000000.obj").find("f 1//1 2//2 3//3\n"), std::string::npos);
}

TEST(RunFolder, SaysThatARunIsRunningWhileItDoes) {
  const ScratchFolder scratch;
  FakeMotion motion;
  std::string ended;
  Hooks hooks;
  hooks.stepped = [&](double) { ended = json::parse(read_file(scratch / "run/run.json"))["ended"]; };
  run_motion(motion, {.last_step = 1}, output_in(scratch.path() / "run"), hooks);
  EXPECT_EQ(ended, "running");
}

TEST(RunFolder, GoesOnBehindACheckpointAsIfNothingHadHappened) {
  const ScratchFolder scratch;
  FakeMotion whole, first;
  run_motion(whole, {.last_step = 12}, output_in(scratch.path() / "whole"));
  run_motion(first, {.last_step = 6}, output_in(scratch.path() / "parts"));
  go_on(scratch.path() / "parts", 12);
  EXPECT_EQ(read_file(scratch / "parts/metrics.csv"), read_file(scratch / "whole/metrics.csv"));
  EXPECT_EQ(frames_listed(scratch.path() / "parts"), frames_listed(scratch.path() / "whole"));
  EXPECT_EQ(read_file(scratch / "parts/frames/frame_000012.ply"), read_file(scratch / "whole/frames/frame_000012.ply"));
}

TEST(RunFolder, CutsBackWhatWasWrittenBehindTheCheckpoint) {
  const ScratchFolder scratch;
  FakeMotion motion, whole;
  // As a killed run leaves it: tables and frames of step 7, the checkpoint of step 4.
  run_motion(motion, {.last_step = 7}, output_in(scratch.path() / "parts"));
  write_checkpoint(scratch.path() / "parts/checkpoint.cbor", {"fake", 1}, {{"steps", 4}});
  go_on(scratch.path() / "parts", 9);
  run_motion(whole, {.last_step = 9}, output_in(scratch.path() / "whole"));
  EXPECT_EQ(read_file(scratch / "parts/metrics.csv"), read_file(scratch / "whole/metrics.csv"));
  EXPECT_EQ(frames_listed(scratch.path() / "parts"), frames_listed(scratch.path() / "whole"));
}

TEST(RunFolder, ListsNoFrameTwiceWhenAFinishedRunIsResumed) {
  const ScratchFolder scratch;
  FakeMotion motion;
  run_motion(motion, {.last_step = 7}, output_in(scratch.path() / "run"));
  const auto before = frames_listed(scratch.path() / "run");
  const Outcome outcome = go_on(scratch.path() / "run", 7);
  EXPECT_EQ(frames_listed(scratch.path() / "run"), before);
  EXPECT_EQ(outcome.last_frame.filename(), "frame_000007.ply");
}

// As where somebody has made room: frames are taken away, and surface.pvd still lists them.
TEST(RunFolder, ListsNoFrameTwiceWhenTheLastIsWrittenAnew) {
  const ScratchFolder scratch;
  FakeMotion motion;
  run_motion(motion, {.last_step = 7}, output_in(scratch.path() / "run"));
  const auto before = frames_listed(scratch.path() / "run");
  fs::remove_all(scratch.path() / "run/frames");
  go_on(scratch.path() / "run", 7);
  EXPECT_EQ(frames_listed(scratch.path() / "run"), before);
  EXPECT_TRUE(fs::exists(scratch.path() / "run/frames/frame_000007.ply"));
}

TEST(RunFolder, HasCheckpointsByWallTime) {
  const ScratchFolder scratch;
  FakeMotion motion;
  Output output = output_in(scratch.path() / "run");
  output.checkpoint_every = 0;
  output.checkpoint_seconds = 1e-9;
  Hooks hooks;
  std::vector<bool> there;
  hooks.stepped = [&](double) { there.push_back(fs::exists(scratch.path() / "run/checkpoint.cbor")); };
  run_motion(motion, {.last_step = 2}, output, hooks);
  EXPECT_EQ(there, (std::vector<bool>{true, true}));
  output.checkpoint_seconds = 0;
  output.force = true;
  FakeMotion other;
  there.clear();
  run_motion(other, {.last_step = 2}, output, hooks);
  EXPECT_EQ(there, (std::vector<bool>{false, false}));
  EXPECT_TRUE(fs::exists(scratch.path() / "run/checkpoint.cbor"));
}

// What a killed run has not finished, in the folder and below.
TEST(RunFolder, IsRidOfUnfinishedFilesWhenARunGoesOnOrReplacesIt) {
  const ScratchFolder scratch;
  FakeMotion motion;
  run_motion(motion, {.last_step = 2}, output_in(scratch.path() / "run"));
  const std::vector<std::string> stale{scratch / "run/.checkpoint.cbor.4194305-0.tmp",
                                       scratch / "run/frames/.frame_000001.ply.4194305-0.tmp"};
  const auto leave_them = [&] {
    for (const std::string& file : stale) std::ofstream(file) << "half";
  };
  leave_them();
  go_on(scratch.path() / "run", 3);
  for (const std::string& file : stale) EXPECT_FALSE(fs::exists(file)) << file;
  leave_them();
  Output output = output_in(scratch.path() / "run");
  output.force = true;
  FakeMotion other;
  run_motion(other, {.last_step = 3}, output);
  for (const std::string& file : stale) EXPECT_FALSE(fs::exists(file)) << file;
}

TEST(RunFolder, KeepsTheLastGoodStateOfAFailure) {
  const ScratchFolder scratch;
  FakeMotion motion;
  motion.fails_at = 6;
  const Outcome outcome = run_motion(motion, {.last_step = 10}, output_in(scratch.path() / "run"));
  EXPECT_EQ(outcome.last_frame.filename(), "frame_000005.ply");
  EXPECT_EQ(FakeMotion::resumed(outcome.checkpoint).steps(), 5);
  EXPECT_EQ(json::parse(read_file(scratch / "run/run.json"))["ended"], "failed");
}

TEST(RunFolder, TellsHowToGoOnAfterAnInterruption) {
  const ScratchFolder scratch;
  FakeMotion motion;
  Hooks hooks;
  hooks.interrupted = [&] { return motion.steps() == 2; };
  const Outcome outcome = run_motion(motion, {.last_step = 10}, output_in(scratch.path() / "run"), hooks);
  EXPECT_NE(outcome.message.find("--resume " + outcome.checkpoint.string()), std::string::npos) << outcome.message;
  EXPECT_EQ(FakeMotion::resumed(outcome.checkpoint).steps(), 2);
}

TEST(RunFolder, IsNotThereAfterAnErrorAtTheStart) {
  const ScratchFolder scratch;
  FakeMotion motion;
  motion.tables_fail = true;
  EXPECT_THROW(run_motion(motion, {.last_step = 1}, output_in(scratch.path() / "a/b")), base::FileError);
  EXPECT_FALSE(fs::exists(scratch.path() / "a"));
}

TEST(RunFolder, KeepsAnotherRunUnlessForced) {
  const ScratchFolder scratch;
  Output output = output_in(scratch.path() / "run");
  FakeMotion first, second, third;
  run_motion(first, {.last_step = 7}, output);
  const std::string before = read_file(scratch / "run/metrics.csv");
  EXPECT_THROW(run_motion(second, {.last_step = 1}, output), base::InputError);
  EXPECT_EQ(read_file(scratch / "run/metrics.csv"), before);
  output.force = true;
  run_motion(third, {.last_step = 1}, output);
  EXPECT_FALSE(fs::exists(scratch.path() / "run/frames/frame_000007.ply"));
}

TEST(RunFolder, HasNoCheckpointOfWhatCannotBeResumed) {
  const ScratchFolder scratch;
  FakeMotion motion;
  motion.saved = false;
  EXPECT_TRUE(run_motion(motion, {.last_step = 5}, output_in(scratch.path() / "run")).checkpoint.empty());
  EXPECT_FALSE(fs::exists(scratch.path() / "run/checkpoint.cbor"));
}

TEST(Checkpoint, ThatARunDidNotComeToIsMissedWithTheWayOn) {
  const ScratchFolder scratch;
  fs::create_directory(scratch / "run");
  std::ofstream(scratch / "run/run.json") << "{}";
  try {
    FakeMotion::resumed(scratch / "run/checkpoint.cbor");
    FAIL();
  } catch (const base::InputError& error) {
    EXPECT_NE(std::string(error.what()).find("--force"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace lostopos::run
