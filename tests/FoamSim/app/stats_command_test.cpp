// foamsim stats: tables of a run's foam, and what is said of folders that have none.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "program.h"
#include "tables.h"

namespace foamsim::test {
namespace {

namespace fs = std::filesystem;

// A run of eight steps with a frame every two.
class StatsCommand : public testing::Test {
 protected:
  void SetUp() override {
    const ProgramResult run =
        run_foamsim("run doublebubble --set n=8 --steps 8 --set frame_every=2 --quiet --out " + (scratch_ / "run"));
    ASSERT_EQ(run.exit_code, 0) << run.error;
  }
  ProgramResult stats(const std::string& more = "") { return run_foamsim("stats " + (scratch_ / "run") + " " + more); }
  void expect_refused(const std::string& part, const std::string& more = "") {
    const ProgramResult result = stats("--quiet " + more);
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(std::ranges::count(result.error, '\n'), 1) << result.error;
    EXPECT_NE(result.error.find(part), std::string::npos) << result.error;
    EXPECT_FALSE(fs::exists(scratch_.path() / "run/stats"));
  }

  ScratchFolder scratch_;
};

TEST_F(StatsCommand, WritesATableOfEachKindAndAPlot) {
  const ProgramResult result = stats("--out " + (scratch_ / "stats"));
  ASSERT_EQ(result.exit_code, 0) << result.error;
  EXPECT_NE(result.out.find("2 bubbles"), std::string::npos) << result.out;
  const auto lines = [&](const char* file) {
    return std::ranges::count(read_file(scratch_.path() / "stats" / file), '\n');
  };
  EXPECT_EQ(lines("foam.csv"), 1 + 5);
  EXPECT_EQ(lines("bubbles.csv"), 1 + 5 * 2);
  EXPECT_EQ(lines("films.csv"), 1 + 5 * 3);
  EXPECT_TRUE(read_file(scratch_.path() / "stats/foam.csv").starts_with("step,time,bubbles,"));
  if (!result.error.empty()) return;  // no matplotlib
  for (const char* plot : {"stats_plot.png", "stats_plot.svg", "stats_plot.pdf"})
    EXPECT_GT(fs::file_size(scratch_.path() / "stats" / plot), 10000u) << plot;
}

TEST_F(StatsCommand, OfOneFrameAlone) {
  const ProgramResult result = stats("--step 4 --no-plot --quiet");
  ASSERT_EQ(result.exit_code, 0) << result.error;
  EXPECT_EQ(result.out, "");
  const std::string bubbles = read_file(scratch_.path() / "run/stats/bubbles.csv");
  EXPECT_EQ(std::ranges::count(bubbles, '\n'), 1 + 2);
  EXPECT_NE(bubbles.find("\n4,0.04,1,"), std::string::npos) << bubbles;
}

TEST_F(StatsCommand, RefusesAStepWithoutAFrame) {
  expect_refused("has no frame of step 3; the last is of step 8", "--step 3");
}

TEST_F(StatsCommand, RefusesFramesThatAreMissingInTheMiddle) {
  fs::remove(scratch_.path() / "run/frames/frame_000004.ply");
  expect_refused("lacks the frame of step 4");
}

TEST_F(StatsCommand, RefusesALastFrameThatIsMissing) {
  fs::remove(scratch_.path() / "run/frames/frame_000008.ply");
  expect_refused("lacks the frame of step 8");
}

TEST_F(StatsCommand, RefusesADamagedFrame) {
  std::ofstream(scratch_.path() / "run/frames/frame_000006.ply") << "ply\n";
  expect_refused("frame_000006.ply");
}

TEST_F(StatsCommand, RefusesADamagedRunJson) {
  std::ofstream(scratch_.path() / "run/run.json") << "{]";
  expect_refused("run.json is not what a run writes there");
  std::ofstream(scratch_.path() / "run/run.json") << R"({"ended": "finished", "first_step": 0, "last_step": -1})";
  expect_refused("last_step");
}

TEST_F(StatsCommand, TakesARunThatGoesOnAsFarAsItIs) {
  auto run = nlohmann::json::parse(read_file(scratch_.path() / "run/run.json"));
  run["ended"] = "running";
  run["last_step"] = 0;
  std::ofstream(scratch_.path() / "run/run.json") << run.dump();
  fs::remove(scratch_.path() / "run/frames/frame_000008.ply");
  ASSERT_EQ(stats("--no-plot").exit_code, 0);
  EXPECT_EQ(std::ranges::count(read_file(scratch_.path() / "run/stats/foam.csv"), '\n'), 1 + 4);
}

TEST(StatsCommandInput, HasToBeTheFolderOfARun) {
  const ScratchFolder scratch;
  ::test::expect_refused(FOAMSIM_PROGRAM,
                         {"nowhere", "stats " + (scratch / "nowhere"), {"no folder of a run", "no such folder"}});
  ::test::expect_refused(FOAMSIM_PROGRAM,
                         {"empty", "stats " + scratch.path().string(), {"no folder of a run", "run.json"}});
}

}  // namespace
}  // namespace foamsim::test
