#include "MultiTracker/study/robustness.h"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <stdexcept>
#include <thread>

#include "Base/error.h"
#include "MultiTracker/study/child_process.h"
#include "tests/support/scratch_folder.h"

namespace multitracker {
namespace {

ChildResult end_of(ForkedChild& child) {
  while (true)
    if (auto result = child.result(0.05)) return *result;
}

ChildResult run_in_child(const std::function<std::string()>& work, double time_limit) {
  ForkedChild child([&](const std::function<bool()>&) { return work(); }, time_limit);
  return end_of(child);
}

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

TEST(ChildProcess, EndsByItselfWhenItIsAskedTo) {
  ForkedChild child(
      [](const std::function<bool()>& stop) {
        while (!stop()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
        return std::string("saved");
      },
      600);
  EXPECT_FALSE(child.result(0));
  child.ask_to_stop();
  const ChildResult result = end_of(child);
  EXPECT_TRUE(result.finished);
  EXPECT_EQ(result.text, "saved");
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
    EXPECT_TRUE(run.success()) << run.message;
    EXPECT_GE(run.triangles, 320.0 * static_cast<double>(run.key.spheres));
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
  for (const RobustnessRun& run : runs) EXPECT_TRUE(run.success()) << run.message;
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
  options.assignments = {};
  options.workers = 0;
  EXPECT_THROW(run_robustness(options), base::InputError);
}

RobustnessOptions kept_in(const ::test::ScratchFolder& scratch) {
  RobustnessOptions options;
  options.spheres = {2};
  options.steps = {0.5};
  options.seeds = 3;
  options.total_motion = 2;
  options.folder = scratch.path() / "study";
  return options;
}

// All but what depends on the machine.
void expect_equal(const std::vector<RobustnessRun>& a, const std::vector<RobustnessRun>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].key, b[i].key);
    EXPECT_EQ(a[i].verdict, b[i].verdict) << a[i].message << b[i].message;
    EXPECT_EQ(a[i].shared_area, b[i].shared_area);
    EXPECT_EQ(a[i].snaps, b[i].snaps);
    EXPECT_EQ(a[i].steps, b[i].steps);
  }
}

TEST(RobustnessFolder, IsTheSameForAnyNumberOfWorkersAndNothingIsRepeated) {
  const ::test::ScratchFolder scratch;
  RobustnessOptions options = kept_in(scratch);
  options.workers = 3;
  std::size_t made = 0;
  const RobustnessHooks hooks{.done = [&](const RobustnessRun&, double) { ++made; }, .interrupted = {}};
  const auto runs = run_robustness(options, hooks);
  EXPECT_EQ(made, 3u);
  expect_equal(run_robustness(options, hooks), runs);
  EXPECT_EQ(made, 3u);
  options.seeds = 4;
  EXPECT_EQ(run_robustness(options, hooks).size(), 4u);
  EXPECT_EQ(made, 4u);
  options.seeds = 3;
  options.folder.clear();
  options.workers = 1;
  expect_equal(run_robustness(options), runs);
}

// Interrupted again and again; each time all go on from their checkpoints.
TEST(RobustnessFolder, GoesOnWhereItWasStoppedToTheSameFigures) {
  const ::test::ScratchFolder scratch;
  RobustnessOptions options = kept_in(scratch);
  options.audit_every_step = true;
  options.steps = {0.1};
  options.workers = 2;
  std::vector<RobustnessRun> runs;
  for (int part = 1; part <= 200 && runs.size() < 3; ++part) {
    int looks = 0;
    runs = run_robustness(options, {.done = {}, .interrupted = [&] { return ++looks > part; }});
  }
  ASSERT_EQ(runs.size(), 3u);
  options.folder.clear();
  expect_equal(run_robustness(options), runs);
}

TEST(RobustnessFolder, OfOtherSettingsIsLeftAlone) {
  const ::test::ScratchFolder scratch;
  RobustnessOptions options = kept_in(scratch);
  options.seeds = 1;
  run_robustness(options);
  options.total_motion = 1;
  EXPECT_THROW(run_robustness(options), base::InputError);
}

TEST(RobustnessUntilClosed, EndsWhenSpheresHaveMetAndIsOpenWhenTheyHaveNot) {
  RobustnessOptions options;
  options.spheres = {2};
  options.steps = {0.5};
  options.seeds = 1;
  options.until_closed = true;
  options.total_motion = 20;
  const auto closed = run_robustness(options);
  ASSERT_EQ(closed.size(), 1u);
  EXPECT_EQ(closed[0].verdict, Verdict::success) << closed[0].message;
  EXPECT_GT(closed[0].shared_area, 0);
  EXPECT_LT(closed[0].steps, 40);
  options.total_motion = 0.5;
  const auto open = run_robustness(options);
  ASSERT_EQ(open.size(), 1u);
  EXPECT_EQ(open[0].verdict, Verdict::open);
  EXPECT_NE(open[0].message.find("voids are left"), std::string::npos);
}

}  // namespace
}  // namespace multitracker
