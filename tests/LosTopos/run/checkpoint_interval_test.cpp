#include "LosTopos/run/checkpoint_interval.h"

#include <gtest/gtest.h>

namespace lostopos::run {
namespace {

TEST(CheckpointInterval, IsThatFromTheEndOfTheLast) {
  CheckpointInterval interval(30);
  EXPECT_FALSE(interval.due(29));
  EXPECT_TRUE(interval.due(30));
  interval.written(31, 31.125);
  EXPECT_FALSE(interval.due(61));
  EXPECT_TRUE(interval.due(61.125));
}

TEST(CheckpointInterval, GrowsWithWhatACheckpointTakes) {
  CheckpointInterval interval(30);
  interval.written(30, 32);
  EXPECT_FALSE(interval.due(231));
  EXPECT_TRUE(interval.due(232));
  interval.written(232, 232.25);
  EXPECT_TRUE(interval.due(262.25));
}

TEST(CheckpointInterval, OfNothingIsNever) {
  EXPECT_FALSE(CheckpointInterval(0).due(1e9));
}

}  // namespace
}  // namespace lostopos::run
