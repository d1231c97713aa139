#include "Base/console/progress.h"

#include <gtest/gtest.h>

namespace base {
namespace {

TEST(ProgressLine, ShowsABarWhereThereIsRoom) {
  EXPECT_EQ(progress_line("run", "step 3", 0.5, 12, 80), "run [###############...............] step 3, 12 s left");
  EXPECT_EQ(progress_line("run", "step 3", 0, -1, 80), "run [..............................] step 3");
}

TEST(ProgressLine, NeverIsWiderThanTheTerminal) {
  const std::string label = "doublebubble", detail = "step 12345, time 123.450";
  for (int width = 0; width <= 120; ++width)
    for (const double fraction : {0.0, 0.3, 1.0, 7.0})
      EXPECT_LE(progress_line(label, detail, fraction, 12345, width).size(), static_cast<std::size_t>(width)) << width;
}

TEST(ProgressLine, ShortensTheBarAndThenLeavesItOut) {
  EXPECT_EQ(progress_line("run", "step 3", 0.5, 12, 34), "run [#####.....] step 3, 12 s left");
  EXPECT_EQ(progress_line("run", "step 3", 0.5, 12, 24), "run step 3, 12 s left");
  EXPECT_EQ(progress_line("run", "step 3", 0.5, 12, 16), "run, 12 s left");
}

TEST(TimeLeft, CountsFromWhereARunWasTakenUp) {
  TimeLeft left;
  EXPECT_LT(left.estimate(0.90, 10), 0);
  EXPECT_NEAR(left.estimate(0.91, 20), 90, 1e-9);
  EXPECT_NEAR(left.estimate(0.95, 60), 50, 1e-9);
}

TEST(TimeLeft, StartsAnewWithAnotherStage) {
  TimeLeft left;
  left.estimate(0, 0);
  EXPECT_NEAR(left.estimate(1, 100), 0, 1e-9);
  EXPECT_LT(left.estimate(0.1, 101), 0);
  EXPECT_NEAR(left.estimate(0.2, 111), 80, 1e-9);
}

}  // namespace
}  // namespace base
