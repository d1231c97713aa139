// The multitracker program as a user meets it: bad input, interruption, what a run leaves, threads.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "LosTopos/io/mesh_file.h"
#include "tests/support/run_program.h"

namespace multitracker {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using ::test::BadCase;
using ::test::ProgramResult;
using ::test::read_file;
using ::test::ScratchFolder;

ProgramResult run_multitracker(const std::string& arguments, const std::string& before = "") {
  return ::test::run_program(MULTITRACKER_PROGRAM, arguments, before);
}

class TrackersBadInput : public testing::TestWithParam<BadCase> {};

TEST_P(TrackersBadInput, IsOneLineThatHelpsAndLeavesNothing) {
  ::test::expect_refused(MULTITRACKER_PROGRAM, GetParam());
}

INSTANTIATE_TEST_SUITE_P(
    Run, TrackersBadInput,
    testing::Values(BadCase{"unknown_scene", "run enrigth", {"unknown scene 'enrigth'", "did you mean 'enright'"}},
                    BadCase{"unknown_option", "run T1 --set gapp=0.1", {"gapp", "did you mean 'gap'"}},
                    BadCase{"option_out_of_range", "run T1 --set gap=5", {"gap has to be at most"}},
                    BadCase{"option_not_a_number", "run T1 --set gap=wide", {"gap", "'wide' is not a number"}},
                    BadCase{"unknown_layout", "run normal-flow --set layout=line", {"layout = line", "grid or random"}},
                    BadCase{"unknown_rule", "run T1 --set topology.separation=speed", {"topology.separation", "area"}},
                    BadCase{
                        "too_many_spheres", "run normal-flow --set spheres=1000000", {"triangles, which take 640 GB"}},
                    BadCase{"more_spheres_than_any", "run merge --set spheres=10000000", {"1 to 1000000"}},
                    BadCase{"too_many_cells", "run mcf --set cells=1000000", {"memory_limit"}},
                    BadCase{"too_many_layers", "run T1 --set layers=1000000", {"1 to 1000"}},
                    BadCase{"too_fine", "run enright --set resolution=1e-6", {"triangles, which take"}},
                    BadCase{"beyond_memory_limit",
                            "run enright --set subdivisions=5 --set memory_limit=0.01",
                            {"more than the limit of 10 MB"}},
                    BadCase{"resolution_out_of_range",
                            "run enright --set remeshing.enabled=false --set resolution=1e-60",
                            {"lengths of 1e-40 to 1e+40"}},
                    BadCase{"negative_steps", "run T1 --steps -1", {"--steps", ">= 0"}},
                    BadCase{"negative_seed", "run T1 --seed -1", {"--seed", ">= 0"}},
                    BadCase{"missing_option_file", "run nowhere.txt", {"nowhere.txt", "no such option file"}},
                    BadCase{"missing_mesh", "run enright --mesh nowhere.ply", {"nowhere.ply"}},
                    BadCase{"unknown_format", "run enright --mesh " MULTITRACKER_PROGRAM, {"known are .ply"}},
                    BadCase{"no_spheres", "study robustness --spheres 0", {"--spheres", "from 1 to"}},
                    BadCase{"no_step", "study robustness --steps-of 0", {"--steps-of 0", "> 0"}},
                    BadCase{"no_scene", "run", {"scene"}},
                    BadCase{"no_checkpoint", "run --resume nowhere.cbor", {"nowhere.cbor", "checkpoint"}},
                    BadCase{"no_whole_checkpoint",
                            "run --resume " MULTITRACKER_PROGRAM,
                            {MULTITRACKER_PROGRAM, "not a whole checkpoint"}},
                    BadCase{"scene_and_checkpoint", "run T1 --resume x", {"--resume", "leave out the scene"}},
                    BadCase{"mistyped_command", "rnu T1", {"unknown command 'rnu'", "did you mean 'run'"}},
                    BadCase{"mistyped_study", "study robustnes", {"did you mean 'robustness'"}},
                    BadCase{"mistyped_flag", "run T1 --adit", {"unknown option '--adit'", "did you mean '--audit'"}},
                    BadCase{"many_options", "run T1 --set qqqqqq=1", {"see 'multitracker scenes T1'"}}),
    [](const auto& info) { return info.param.name; });

// A surface that is inside out, with vertices that nothing uses, from an option file with the mesh beside it.
TEST(OptionFile, RunsWithTheMeshBesideItMendedAndAudited) {
  const ScratchFolder scratch;
  std::ofstream(scratch / "noise.txt") << "scene noise\ntime-step 0.01\nsimulation-time 0.05\noutput-mesh 1\n"
                                          "output-mesh-every-n-frames 5\nlostopos-allow-topology-changes 0\n";
  ASSERT_EQ(run_multitracker("run noise --steps 0 --quiet --out " + (scratch / "start")).exit_code, 0);
  lostopos::SurfaceData data = lostopos::read_surface(scratch / "start/frames/frame_000000.ply");
  for (lostopos::Labels& labels : data.labels) labels = labels.flipped();
  data.positions.insert(data.positions.end(), 3, {2, 2, 2});
  lostopos::write_surface(scratch / "noise.arec", data);
  const ProgramResult result =
      run_multitracker("run " + (scratch / "noise.txt") + " --audit --out " + (scratch / "run"));
  EXPECT_EQ(result.exit_code, 0) << result.error;
  EXPECT_NE(result.error.find("3 vertices that no triangle uses are dropped"), std::string::npos) << result.error;
  EXPECT_NE(result.error.find("inside out"), std::string::npos) << result.error;
  EXPECT_TRUE(fs::exists(scratch.path() / "run/rec/mesh000000.rec"));
  EXPECT_TRUE(fs::exists(scratch.path() / "run/rec/mesh000005.rec"));
}

TEST(TrackersBadInput, AFullFolderIsKeptUnlessForced) {
  const ScratchFolder scratch;
  const std::string command = "run T1 --steps 2 --quiet --out " + (scratch / "run");
  ASSERT_EQ(run_multitracker(command).exit_code, 0);
  const std::string metrics = read_file(scratch / "run/metrics.csv");
  EXPECT_EQ(run_multitracker(command).exit_code, 2);
  EXPECT_EQ(read_file(scratch / "run/metrics.csv"), metrics);
  EXPECT_EQ(run_multitracker(command + " --force").exit_code, 0);
}

TEST(TrackersBadInput, AMistypedStudyKeepsTheTableOfTheLast) {
  const ScratchFolder scratch;
  std::ofstream(scratch / "table.csv") << "of last night\n";
  EXPECT_EQ(run_multitracker("study robustness --seeds 0 --out " + (scratch / "table.csv")).exit_code, 2);
  EXPECT_EQ(read_file(scratch / "table.csv"), "of last night\n");
}

TEST(TrackersBadInput, AMeshWhoseSurfaceIsDamagedIsRefused) {
  const ScratchFolder scratch;
  std::ofstream(scratch / "cut.ply") << "ply\nformat ascii 1.0\nelement vertex 3\n";
  const ProgramResult result = run_multitracker("run enright --mesh " + (scratch / "cut.ply"));
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_NE(result.error.find("line 4"), std::string::npos) << result.error;
}

TEST(TrackersFullDisk, EndsTheRunWithAMessage) {
  const ScratchFolder scratch;
  const ProgramResult result =
      run_multitracker("run enright --steps 5 --quiet --out " + (scratch / "run"), "ulimit -f 20;");
  EXPECT_EQ(result.exit_code, 4) << result.error;
  EXPECT_NE(result.error.find("cannot write"), std::string::npos) << result.error;
}

TEST(Interrupted, FinishesTheStepAndKeepsWhatThereIs) {
  const ScratchFolder scratch;
  const ProgramResult result = run_multitracker("run noise --steps 1000000 --out " + (scratch / "run"),
                                                "timeout --foreground --preserve-status -s INT 2");
  EXPECT_EQ(result.exit_code, 130) << result.error;
  const json run = json::parse(read_file(scratch / "run/run.json"));
  EXPECT_EQ(run["ended"], "interrupted");
  // The last frame starts another run.
  const std::string last = run["last_frame"].get<std::string>();
  const fs::path frame = scratch.path() / "run/frames" / fs::path(last).filename();
  EXPECT_EQ(run_multitracker("run noise --steps 1 --mesh " + frame.string()).exit_code, 0);
}

// Flow, surface from a file, remeshing, what the last step has moved: all as if there had been no pause.
TEST(Interrupted, GoesOnToTheSameBits) {
  const ScratchFolder scratch;
  ASSERT_EQ(run_multitracker("run normal-flow --steps 0 --quiet --out " + (scratch / "mesh")).exit_code, 0);
  const std::string mesh = (scratch / "mesh/frames/frame_000000.ply");
  for (const std::string& scene :
       std::vector<std::string>{"normal-flow --set step=0.1 --set frame_every=5", "zalesak", "mcf --set cells=12",
                                "normal-flow --set step=0.1 --mesh " + mesh}) {
    const std::string whole = scratch / "whole", parts = scratch / "parts";
    const auto run_for = [&scene](const char* steps, const std::string& folder) {
      std::string command = "run ";
      for (const std::string& word :
           {scene, std::string(" --force --quiet --steps "), std::string(steps), std::string(" --out "), folder})
        command += word;
      return run_multitracker(command);
    };
    const ProgramResult uninterrupted = run_for("15", whole);
    ASSERT_EQ(uninterrupted.exit_code, 0) << uninterrupted.error;
    ASSERT_EQ(run_for("8", parts).exit_code, 0);
    const ProgramResult resumed = run_multitracker("run --resume " + parts + " --steps 15 --quiet");
    ASSERT_EQ(resumed.exit_code, 0) << resumed.error;
    for (const char* file : {"/frames/frame_000015.ply", "/volumes.csv", "/events.csv"})
      EXPECT_TRUE(read_file(parts + file) == read_file(whole + file)) << scene << file;
    EXPECT_EQ(json::parse(read_file(parts + "/run.json"))["start"],
              json::parse(read_file(whole + "/run.json"))["start"]);
  }
}

// Large enough to be put in order in memory on the way, which must not depend on where a run was resumed.
TEST(LargeSurface, HasTheSameBitsWithAnyThreadsAndResumed) {
  const ScratchFolder scratch;
  const std::string scene = "run normal-flow --set spheres=165 --set layout=random --set step=0.2 --quiet";
  const std::string whole = scratch / "whole", parts = scratch / "parts";
  ASSERT_EQ(run_multitracker(scene + " --steps 4 --threads 1 --out " + whole).exit_code, 0);
  ASSERT_EQ(run_multitracker(scene + " --steps 2 --threads 2 --out " + parts).exit_code, 0);
  ASSERT_EQ(run_multitracker("run --resume " + parts + " --steps 4 --threads 2 --quiet").exit_code, 0);
  for (const char* file : {"/frames/frame_000004.ply", "/volumes.csv", "/events.csv"})
    EXPECT_TRUE(read_file(parts + file) == read_file(whole + file)) << file;
}

TEST(Interrupted, ByAKillGoesOnToTheSameBits) {
  const ScratchFolder scratch;
  // Steps enough for some seconds on the fastest of machines.
  const std::string scene = "run zalesak --set checkpoint_every=1 --steps 150 --quiet --force --out ";
  const std::string whole = scratch / "whole", parts = scratch / "parts";
  ASSERT_EQ(run_multitracker(scene + whole).exit_code, 0);
  EXPECT_EQ(run_multitracker(scene + parts, "timeout -s KILL 1").exit_code, 137);
  ASSERT_TRUE(fs::exists(parts + "/checkpoint.cbor"));
  EXPECT_EQ(run_multitracker("run --resume " + parts + " --steps 150 --quiet").exit_code, 0);
  for (const char* file : {"/frames/frame_000150.ply", "/volumes.csv", "/events.csv"})
    EXPECT_TRUE(read_file(parts + file) == read_file(whole + file)) << file;
}

TEST(Interrupted, SaysHowToGoOn) {
  const ScratchFolder scratch;
  const ProgramResult result = run_multitracker("run noise --steps 1000000 --out " + (scratch / "run"),
                                                "timeout --foreground --preserve-status -s TERM 1");
  EXPECT_NE(result.out.find("to go on: multitracker run --resume " + (scratch / "run/checkpoint.cbor") +
                            " --steps 1000000\n"),
            std::string::npos)
      << result.out;
}

TEST(Interrupted, ExitCodeTellsTheSignal) {
  for (const auto& [signal, code] : {std::pair{"TERM", 143}, {"HUP", 129}})
    EXPECT_EQ(run_multitracker("run noise --steps 1000000 --quiet",
                               std::string("timeout --foreground --preserve-status -s ") + signal + " 1")
                  .exit_code,
              code);
}

TEST(TrackersFullDisk, BehindStdoutIsAnError) {
  const ProgramResult result = ::test::run_program("sh -c '" MULTITRACKER_PROGRAM, "scenes >/dev/full'");
  EXPECT_EQ(result.exit_code, 4);
  EXPECT_NE(result.error.find("cannot write the output"), std::string::npos) << result.error;
}

TEST(Run, HasTheSameBitsWithOneThreadAndWithTwo) {
  const ScratchFolder scratch;
  for (const char* threads : {"1", "2"})
    ASSERT_EQ(run_multitracker("run normal-flow --steps 25 --set step=0.1 --quiet --threads " + std::string(threads) +
                               " --out " + (scratch / threads))
                  .exit_code,
              0);
  for (const char* file : {"/events.csv", "/volumes.csv", "/frames/frame_000025.ply"}) {
    const std::string one = read_file(scratch / "1" + file);
    EXPECT_FALSE(one.empty());
    EXPECT_TRUE(one == read_file(scratch / "2" + file)) << file;
  }
}

TEST(Events, NameStepTimeKindRegionsAndPosition) {
  const ScratchFolder scratch;
  ASSERT_EQ(run_multitracker("run T1 --set gap=0 --steps 5 --quiet --out " + (scratch / "run")).exit_code, 0);
  std::ifstream in(scratch / "run/events.csv");
  std::string line;
  std::getline(in, line);
  EXPECT_EQ(line, "step,time,kind,regions,x,y,z");
  std::size_t separations = 0;
  while (std::getline(in, line)) separations += line.find(",separation,") != std::string::npos;
  EXPECT_GT(separations, 0u);
}

}  // namespace
}  // namespace multitracker
