#include "FoamSim/statistics/statistics_tables.h"

#include <gtest/gtest.h>

#include <fstream>

#include "Base/error.h"
#include "FoamSim/scenes/shapes/exact_double_bubble.h"
#include "tests/support/scratch_folder.h"

namespace foamsim::test {
namespace {

FrameStatistics double_bubble_frame() {
  return {.step = 8, .time = 0.5, .foam = foam_statistics(exact_double_bubble(double_bubble_equilibrium(1, 2), 12))};
}

TEST(StatisticsTables, HaveARowABubbleAndARowAFilm) {
  const FrameStatistics frame = double_bubble_frame();
  EXPECT_EQ(std::ranges::count(bubble_table_rows(frame), '\n'), 2);
  EXPECT_EQ(std::ranges::count(film_table_rows(frame), '\n'), 3);
  EXPECT_EQ(std::ranges::count(foam_table_row(frame), '\n'), 1);
  EXPECT_EQ(std::ranges::count(foam_table_row(frame), ','), std::ranges::count(foam_table_header(), ','));
  EXPECT_EQ(std::ranges::count(bubble_table_rows(frame), ','), 2 * std::ranges::count(bubble_table_header(), ','));
}

TEST(StatisticsTables, DistributionsCountEveryBubbleAndFilm) {
  EXPECT_EQ(distribution_table_rows(double_bubble_frame()),
            "8,0.5,faces,2,2\n8,0.5,neighbours,1,2\n8,0.5,film_edges,1,3\n8,0.5,volume,0.7,1\n8,0.5,volume,1.3,1\n");
}

TEST(StatisticsTables, RatesAreCountsOverTheTimeSinceTheFrameBefore) {
  FrameStatistics frame = double_bubble_frame();
  EXPECT_TRUE(foam_table_row(frame).ends_with(",,,,,,\n"));  // no events recorded
  frame.since = 0.25;
  frame.events = EventCounts{.t1 = 3, .bursts = 1, .vanished = 0};
  EXPECT_TRUE(foam_table_row(frame).ends_with(",3,1,0,12,4,0\n")) << foam_table_row(frame);
}

TEST(RunEvents, CountsByKindAfterOneStepUntilAnother) {
  const ::test::ScratchFolder scratch;
  const auto file = scratch.path() / "events.csv";
  std::ofstream(file) << "step,time,kind,regions,x,y,z\n"
                         "2,0.2,separation,1 2,0,0,0\n2,0.2,snap,1 2,0,0,0\n3,0.3,burst,1 0,0,0,0\n"
                         "4,0.4,separation,1 2,0,0,0\n4,0.4,region_collapse,3,0,0,0\n";
  const EventCounts counts = RunEvents(file).between(2, 4);
  EXPECT_EQ(counts.t1, 1);
  EXPECT_EQ(counts.bursts, 1);
  EXPECT_EQ(counts.vanished, 1);
  EXPECT_EQ(RunEvents(file).between(0, 2).t1, 1);
  std::ofstream(file, std::ios::app) << "soon,0.5,separation,1 2,0,0,0\n";
  EXPECT_THROW(RunEvents{file}, base::InputError);
}

}  // namespace
}  // namespace foamsim::test
