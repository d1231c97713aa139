// How a run ends, and what it sums.
#include <gtest/gtest.h>

#include "tests/LosTopos/run/fake_motion.h"

namespace lostopos::run {
namespace {

using test::FakeMotion;

TEST(Run, EndsWithItsLastStep) {
  FakeMotion motion;
  const Outcome outcome = run_in_memory(motion, {.last_step = 7});
  EXPECT_EQ(outcome.end, End::finished);
  EXPECT_EQ(outcome.message, "");
  EXPECT_EQ(motion.steps(), 7);
  EXPECT_EQ(outcome.work.times.seconds("rise"), 7 * 0.25);
  EXPECT_TRUE(outcome.work.topology.events.empty());
}

TEST(Run, EndsAtRestOrSaysThatItDidNot) {
  FakeMotion motion;
  Plan plan{.last_step = 10, .at_rest = [&] { return motion.steps() == 4; }};
  EXPECT_EQ(run_in_memory(motion, plan).end, End::at_rest);
  EXPECT_EQ(motion.steps(), 4);
  plan.at_rest = [] { return false; };
  const Outcome outcome = run_in_memory(motion, plan);
  EXPECT_EQ(outcome.end, End::not_at_rest);
  EXPECT_NE(outcome.message.find("step 10"), std::string::npos) << outcome.message;
}

TEST(Run, StopsWhenAskedTo) {
  FakeMotion motion;
  EXPECT_EQ(run_in_memory(motion, {.last_step = 10, .stop = [&] { return motion.steps() == 3; }}).end, End::stopped);
  EXPECT_EQ(motion.steps(), 3);
}

TEST(Run, IsInterruptedBetweenSteps) {
  FakeMotion motion;
  std::vector<double> fractions;
  const Outcome outcome = run_in_memory(motion, {.last_step = 10},
                                        {.stepped = [&](double fraction) { fractions.push_back(fraction); },
                                         .interrupted = [&] { return motion.steps() == 2; }});
  EXPECT_EQ(outcome.end, End::interrupted);
  EXPECT_EQ(fractions, (std::vector<double>{0.1, 0.2}));
}

TEST(Run, IsInterruptedWithinAStepWithTheOneBeforeAsItsLast) {
  FakeMotion motion;
  motion.interrupted_at = 5;
  const Outcome outcome = run_in_memory(motion, {.last_step = 10});
  EXPECT_EQ(outcome.end, End::interrupted);
  EXPECT_EQ(motion.steps(), 4);
}

TEST(Run, FailsWithTheStepThatCannotBeDone) {
  FakeMotion motion;
  motion.fails_at = 3;
  const Outcome outcome = run_in_memory(motion, {.last_step = 10});
  EXPECT_EQ(outcome.end, End::failed);
  EXPECT_EQ(outcome.message, "step 3: stuck");
  EXPECT_EQ(motion.steps(), 2);
}

TEST(Run, FailsWithTheStepThatLeavesADefect) {
  FakeMotion motion;
  const Outcome outcome = run_in_memory(
      motion, {.last_step = 10, .defect = [&] { return motion.steps() == 5 ? "a hole" : std::string(); }});
  EXPECT_EQ(outcome.end, End::failed);
  EXPECT_EQ(outcome.message, "step 5: a hole");
}

TEST(Run, ThrowsOnWhatNoRunCanGoOnWith) {
  FakeMotion motion;
  motion.bad_input_at = 2;
  EXPECT_THROW(run_in_memory(motion, {.last_step = 10}), base::InputError);
}

TEST(Run, SaysThatNothingWasLeftToDo) {
  FakeMotion motion(50);
  const Outcome outcome = run_in_memory(motion, {.last_step = 50});
  EXPECT_EQ(outcome.end, End::finished);
  EXPECT_NE(outcome.message.find("already at step 50"), std::string::npos) << outcome.message;
}

TEST(Steps, AreCountedFromTimesUpToTheLargest) {
  EXPECT_EQ(steps_of(4, 0.01), 400);
  EXPECT_EQ(steps_of(0.05, 0.01), 5);
  EXPECT_EQ(steps_of(1e6, 0.01), 100000000);
  EXPECT_THROW(steps_of(1e300, 0.01), base::InputError);
  EXPECT_THROW(steps_of(4, 1e-300), base::InputError);
  EXPECT_THROW(steps_of(1, 1e-320), base::InputError);
  EXPECT_THROW(require_countable(1e20, 0.01), base::InputError);
  EXPECT_NO_THROW(require_countable(1e15, 0.01));
}

}  // namespace
}  // namespace lostopos::run
