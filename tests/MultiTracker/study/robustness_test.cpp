#include "MultiTracker/study/robustness.h"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <stdexcept>
#include <thread>

#include "Base/error.h"
#include "MultiTracker/study/child_process.h"

namespace multitracker {
namespace {

TEST(ChildProcess, ReturnsTextMemoryAndTime) {
  const ChildResult result = run_in_child(
      [] {
        const std::vector<char> block(64 << 20, 'x');
        return std::string(1000000, block[12345]);
      },
      60);
  EXPECT_TRUE(result.finished);
  EXPECT_EQ(result.text, std::string(1000000, 'x'));
  EXPECT_GT(result.peak_megabytes, 64);
  EXPECT_GT(result.cpu_seconds, 0);
}

TEST(ChildProcess, SaysHowItFailed) {
  const ChildResult thrown = run_in_child([]() -> std::string { throw std::runtime_error("no way"); }, 60);
  EXPECT_FALSE(thrown.finished);
  EXPECT_EQ(thrown.text, "no way");
  const ChildResult crashed = run_in_child(
      []() -> std::string {
        std::raise(SIGKILL);
        return "not reached";
      },
      60);
  EXPECT_FALSE(crashed.finished);
  EXPECT_NE(crashed.text.find("signal"), std::string::npos);
  const ChildResult slow = run_in_child(
      []() -> std::string {
        std::this_thread::sleep_for(std::chrono::seconds(60));
        return "not reached";
      },
      0.2);
  EXPECT_FALSE(slow.finished);
  EXPECT_NE(slow.text.find("took more than"), std::string::npos);
}

TEST(Robustness, RunsAndSumsUp) {
  RobustnessOptions options;
  options.spheres = {1, 2};
  options.steps = {0.2, 0.16};
  options.seeds = 2;
  options.total_motion = 0.4;
  const auto runs = run_robustness(options);
  ASSERT_EQ(runs.size(), 8u);
  for (const RobustnessRun& run : runs) {
    EXPECT_TRUE(run.success) << run.message;
    EXPECT_GE(run.triangles, 320 * run.spheres);
    EXPECT_EQ(run.shared_area, 0);
  }
  // The same way in two steps and in three (0.16 is rounded to a third of it).
  EXPECT_NEAR(runs[0].air_area / runs[2].air_area, 1, 1e-3);
  const auto summaries = summarise(runs);
  ASSERT_EQ(summaries.size(), 4u);
  EXPECT_EQ(summaries[3].spheres, 2);
  EXPECT_EQ(summaries[3].successes, 2);
}

// Walls that have formed within a long step must not go on moving with what is left of it: they would share 13% more.
TEST(Robustness, SharesAsMuchAreaInLongStepsAsInShortOnes) {
  RobustnessOptions options;
  options.spheres = {8};
  options.steps = {0.05, 1};
  options.seeds = 1;
  const auto runs = run_robustness(options);
  ASSERT_EQ(runs.size(), 2u);
  for (const RobustnessRun& run : runs) EXPECT_TRUE(run.success) << run.message;
  EXPECT_NEAR(runs[1].shared_area / runs[0].shared_area, 1, 0.06);
}

TEST(Robustness, RefusesBadOptionsBeforeTheFirstRun) {
  RobustnessOptions options;
  options.seeds = 0;
  EXPECT_THROW(run_robustness(options), base::InputError);
  options.seeds = 1;
  options.steps = {0.5, -1};
  EXPECT_THROW(run_robustness(options), base::InputError);
  options.steps = {0.5};
  options.assignments = {"no_such_key=1"};
  EXPECT_THROW(run_robustness(options), base::InputError);
}

}  // namespace
}  // namespace multitracker
