#include "Base/timing/stopwatch.h"

#include <gtest/gtest.h>

#include <thread>

namespace base {
namespace {

constexpr double nap = 0.01;  // s

void sleep_a_little() {
  std::this_thread::sleep_for(std::chrono::duration<double>(nap));
}

TEST(Stopwatch, TellsTheTimeSinceItStartedAndStartsAgain) {
  Stopwatch watch;
  sleep_a_little();
  const double first = watch.restart();
  EXPECT_GE(first, nap);
  EXPECT_LT(watch.seconds(), first);
}

TEST(TimedScope, AddsItsLifeToASumOrAStage) {
  double sum = 1;
  StageTimes times;
  times.add("sleep", 2);
  {
    const TimedScope timed(sum);
    const TimedScope stage(times, "sleep");
    const TimedScope other(times, "other");
    sleep_a_little();
  }
  EXPECT_GE(sum, 1 + nap);
  EXPECT_GE(times.seconds("sleep"), 2 + nap);
  EXPECT_GE(times.seconds("other"), nap);
}

}  // namespace
}  // namespace base
