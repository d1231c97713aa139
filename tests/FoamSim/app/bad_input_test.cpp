// What a user gets who mistypes or points at the wrong place: one line that says what would be
// right, exit 2, nothing left behind.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "program.h"

namespace foamsim::test {
namespace {

namespace fs = std::filesystem;

using ::test::BadCase;

class BadInput : public testing::TestWithParam<BadCase> {};

TEST_P(BadInput, IsOneLineThatHelpsAndLeavesNothing) {
  ::test::expect_refused(FOAMSIM_PROGRAM, GetParam());
}

INSTANTIATE_TEST_SUITE_P(
    Run, BadInput,
    testing::Values(
        BadCase{"unknown_scene", "run doublebuble", {"unknown scene 'doublebuble'", "did you mean 'doublebubble'"}},
        BadCase{"unknown_strategy", "run doublebubble --area avraged", {"avraged", "did you mean 'averaged'"}},
        BadCase{
            "unknown_strategy_in_compare", "compare doublebubble --areas naive,avraged", {"did you mean 'averaged'"}},
        BadCase{"unknown_effect", "run sphere --set effects+=difusion", {"difusion", "did you mean 'diffusion'"}},
        BadCase{"unknown_option", "run sphere --set sigmaa=1", {"sigmaa", "did you mean 'sigma'"}},
        BadCase{"unknown_command", "rum sphere", {"unknown command 'rum'", "did you mean 'run'"}},
        BadCase{"unknown_integrator", "run sphere --set integrator=rk5", {"rk5", "did you mean 'rk4'"}},
        BadCase{"n_too_small", "run doublebubble --set n=7", {"n = 7", "8"}},
        BadCase{"n_not_whole", "run doublebubble --set n=16.5", {"n", "whole number"}},
        BadCase{"n_absurd", "run sphere --set n=1000000", {"1000000", "0 to 8"}},
        BadCase{"dt_zero", "run sphere --set dt=0", {"dt = 0", "> 0"}},
        BadCase{"dt_negative", "run sphere --set dt=-0.01", {"dt = -0.01", "> 0"}},
        BadCase{"dt_nan", "run sphere --set dt=nan", {"dt", "> 0"}},
        BadCase{"dt_word", "run sphere --set dt=fast", {"dt", "'fast' is not a number"}},
        BadCase{"not_an_assignment", "run sphere --set dt", {"key=value"}},
        BadCase{"option_of_an_absent_effect", "run sphere --set damping=0.5", {"damping", "effects+=damping"}},
        BadCase{"burst_of_a_region_that_is_not_there",
                "run doublebubble --set effects+=burst --set burst_region=7",
                {"burst_region names region 7", "1 to 2"}},
        BadCase{"burst_of_the_air", "run doublebubble --set effects+=burst --set burst_region=0", {"air"}},
        BadCase{"bursts_at_no_time",
                "run doublebubble --set effects+=burst --set burst_times=1,soon",
                {"burst_times", "numbers >= 0"}},
        BadCase{
            "blow_into_a_region_that_is_not_there", "run straw --set blow_region=5", {"blow_region 5", "go up to 1"}},
        BadCase{"blow_where_nothing_is_held",
                "run doublebubble --set effects+=blow --set 'blow_where=x > 0'",
                {"blow_where", "held"}},
        BadCase{"area_of_an_implicit_integrator",
                "run sphere --set integrator=implicit --set area=naive",
                {"area", "integrator=implicit has its own curvature"}},
        BadCase{"implicit_integrator_of_conservative",
                "run sphere --set integrator=implicit --set dynamics=conservative",
                {"integrator", "stepping"}},
        BadCase{"option_of_another_scene", "run doublebubble --set mode=3", {"mode", "scene 'mode'"}},
        BadCase{"option_of_flying_bubbles", "run twobubbles --set gap=0.3", {"gap", "scene 'headon'"}},
        BadCase{"option_of_frames",
                "run quadjunction --set displacement=0.1",
                {"displacement", "scenes 'triplejunction-frame', 'quadjunction-frame'"}},
        BadCase{"option_of_another_strategy", "run doublebubble --set phi=0.9", {"phi", "'constant-edge'"}},
        BadCase{"bounds_that_contradict", "run doublebubble --set remeshing.shortest_edge=0.9", {"shortest_edge"}},
        BadCase{"negative_steps", "run sphere --steps -3", {"--steps"}},
        BadCase{"nan_time", "run sphere --time nan", {"--time"}},
        BadCase{"unknown_flag", "run sphere --stepz 3", {"stepz"}},
        BadCase{"option_of_no_row",
                "compare doublebubble --areas naive,averaged --set phi=0.75",
                {"'phi'", "constant-edge"}},
        BadCase{"mistyped_flag", "compare --ares naive sphere", {"unknown option '--ares'", "did you mean '--areas'"}},
        BadCase{"short_flag", "-v", {"unknown option '-v'", "did you mean '--version'"}},
        BadCase{"mistyped_study", "study mode", {"unknown study 'mode'", "did you mean 'modes'"}},
        BadCase{"a_word_too_many", "run sphere cube", {"'cube' is a word too many"}},
        BadCase{"a_folder", "run /tmp", {"/tmp is a folder", "foamsim scenes"}},
        BadCase{"group_left_out", "run sphere --set longest_edge=1", {"did you mean 'remeshing.longest_edge'"}},
        BadCase{"steps_not_whole", "run sphere --steps 1.5", {"--steps: '1.5' is not a whole number"}},
        BadCase{"steps_twice", "run sphere --steps 1 --steps 2", {"--steps is given more than once"}},
        BadCase{"negative_threads", "run sphere --threads -1", {"--threads"}},
        BadCase{"unknown_part", "reproduce tabel1", {"did you mean 'table1'"}},
        BadCase{"no_pixels", "render a.ply --size 0x0", {"--size 0x0", "1 to 32768 pixels"}},
        BadCase{"no_size", "render a.ply --size big", {"WIDTHxHEIGHT"}},
        BadCase{"no_rays", "render a.ply --samples 0", {"--samples", "1 to 4096"}},
        BadCase{"no_direction", "render a.ply --view 0 0 0", {"--view", "direction"}},
        BadCase{"half_a_direction", "render a.ply --view 0 1", {"--view"}},
        BadCase{"unknown_background", "render a.ply --background drak", {"did you mean 'dark'"}},
        BadCase{"missing_scene_file", "run nowhere.toml", {"nowhere.toml"}},
        BadCase{"missing_mesh_file", "run nowhere.ply", {"nowhere.ply"}},
        BadCase{"missing_checkpoint", "run --resume nowhere.cbor", {"nowhere.cbor", "checkpoint"}}),
    [](const auto& info) { return info.param.name; });

void expect_refused(const ProgramResult& result, const std::string& part) {
  EXPECT_EQ(result.exit_code, 2) << result.error;
  EXPECT_EQ(std::ranges::count(result.error, '\n'), 1) << result.error;
  EXPECT_NE(result.error.find(part), std::string::npos) << result.error;
}

TEST(BadFiles, TomlErrorsNameFileAndLine) {
  const ScratchFolder scratch;
  auto refused_with = [&](const std::string& text, const std::string& part) {
    std::ofstream(scratch / "scene.toml") << text;
    expect_refused(run_foamsim("run " + (scratch / "scene.toml") + " --out " + (scratch / "run")), part);
  };
  refused_with("scene = \"sphere\"\nsigmaa = 2\n", "scene.toml:2: unknown option 'sigmaa'; did you mean 'sigma'");
  refused_with("scene = \"sphere\"\n\ndt = \"fast\"\n", "scene.toml:3: dt");
  refused_with("scene = \"spher\"\n", "scene.toml:1: unknown scene 'spher'; did you mean 'sphere'");
  refused_with("scene = sphere\n", "scene.toml:1: not valid TOML");
  refused_with("dt = 0.01\n", "needs either scene");
  EXPECT_FALSE(fs::exists(scratch.path() / "run"));
}

TEST(BadFiles, ReferenceOptionFileErrorsNameFileAndLine) {
  const ScratchFolder scratch;
  std::ofstream(scratch / "old.txt") << "scene doublebubble\ntime-stepp 0.01\n";
  expect_refused(run_foamsim("run " + (scratch / "old.txt") + " --out " + (scratch / "run")),
                 "old.txt:2: unknown key 'time-stepp'; did you mean 'time-step'");
}

TEST(BadFiles, ABrokenMeshIsRefused) {
  const ScratchFolder scratch;
  std::ofstream(scratch / "cut.ply") << "ply\nformat ascii 1.0\nelement vertex 3\n";
  expect_refused(run_foamsim("run " + (scratch / "cut.ply") + " --out " + (scratch / "run")), "cut.ply");
  expect_refused(run_foamsim("inspect " + (scratch / "cut.ply")), "cut.ply");
  expect_refused(run_foamsim("convert " + (scratch / "cut.ply") + " " + (scratch / "x.obj")), "cut.ply");
  expect_refused(run_foamsim("render " + (scratch / "cut.ply") + " --out " + (scratch / "pictures")), "cut.ply");
  EXPECT_FALSE(fs::exists(scratch.path() / "x.obj"));
  EXPECT_FALSE(fs::exists(scratch.path() / "pictures"));
}

TEST(BadFiles, ACutCheckpointIsRefused) {
  const ScratchFolder scratch;
  ASSERT_EQ(run_foamsim("run sphere --set n=1 --steps 2 --out " + (scratch / "run")).exit_code, 0);
  const std::string whole = read_file(scratch / "run/checkpoint.cbor");
  for (std::size_t size : {std::size_t{0}, std::size_t{1}, whole.size() / 3, whole.size() - 1}) {
    std::ofstream(scratch / "cut.cbor", std::ios::binary) << whole.substr(0, size);
    expect_refused(run_foamsim("run --resume " + (scratch / "cut.cbor") + " --out " + (scratch / "more")),
                   "checkpoint");
  }
  EXPECT_FALSE(fs::exists(scratch.path() / "more"));
}

TEST(BadFiles, AnAlteredCheckpointIsRefusedByItsName) {
  const ScratchFolder scratch;
  ASSERT_EQ(run_foamsim("run sphere --set n=1 --steps 2 --out " + (scratch / "run")).exit_code, 0);
  const std::string whole = read_file(scratch / "run/checkpoint.cbor");
  const std::string resume = "run --resume " + (scratch / "x.cbor") + " --out " + (scratch / "more");
  for (std::size_t place : {std::size_t{3}, std::size_t{12}, whole.size() / 2, whole.size() - 1}) {
    std::string altered = whole;
    altered[place] = static_cast<char>(altered[place] ^ 4);
    std::ofstream(scratch / "x.cbor", std::ios::binary) << altered;
    expect_refused(run_foamsim(resume), "x.cbor is not a whole checkpoint: it ");
  }
  // As it was written once: without a head.
  std::ofstream(scratch / "x.cbor", std::ios::binary) << "\xa2"
                                                         "fformatrfoamsim checkpoint"
                                                         "gversion\x04";
  expect_refused(run_foamsim(resume), "it is a foamsim checkpoint of version 4");
  EXPECT_FALSE(fs::exists(scratch.path() / "more"));
}

TEST(BadFiles, TheFolderOfARunIsNoSceneAndTheMessageSaysHowToGoOn) {
  const ScratchFolder scratch;
  ASSERT_EQ(run_foamsim("run sphere --set n=1 --steps 2 --out " + (scratch / "run")).exit_code, 0);
  expect_refused(run_foamsim("run " + (scratch / "run")), "run --resume " + (scratch / "run/checkpoint.cbor"));
}

TEST(BadCommand, NoneNamesThoseThereAre) {
  expect_refused(run_foamsim(""), "needs a command: run, compare");
  expect_refused(run_foamsim("study"), "needs a command: modes, accuracy, stability");
}

TEST(BadFiles, AMessageListsSuggestionsNotEveryOption) {
  const ProgramResult result = run_foamsim("run sphere --set qqqqqqqqqqqq=1");
  expect_refused(result, "see 'foamsim scenes'");
  EXPECT_LT(result.error.size(), 100U) << result.error;
}

TEST(BadOutput, AFolderThatHoldsARunIsRefusedUnlessForced) {
  const ScratchFolder scratch;
  const std::string command = "run sphere --set n=1 --steps 2 --out " + (scratch / "run");
  ASSERT_EQ(run_foamsim(command).exit_code, 0);
  const std::string before = read_file(scratch / "run/metrics.csv");
  expect_refused(run_foamsim(command), "--force");
  EXPECT_EQ(read_file(scratch / "run/metrics.csv"), before);
  EXPECT_EQ(run_foamsim(command + " --force").exit_code, 0);
}

TEST(BadOutput, APlaceThatCannotBeWrittenToIsRefused) {
  const ScratchFolder scratch;
  std::ofstream(scratch / "file") << "not a folder";
  expect_refused(run_foamsim("run sphere --set n=1 --steps 2 --out " + (scratch / "file")), "folder");
  expect_refused(run_foamsim("run sphere --set n=1 --steps 2 --out " + (scratch / "file/below")), "folder");
  expect_refused(run_foamsim("run sphere --set n=1 --steps 2 --out /proc/foamsim"), "/proc/foamsim");
  EXPECT_EQ(read_file(scratch / "file"), "not a folder");
}

}  // namespace
}  // namespace foamsim::test
