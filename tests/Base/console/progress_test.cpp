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

}  // namespace
}  // namespace base
