// Folders that are no run's, or only half of one.
#include "FoamSim/web/run_contents.h"

#include <gtest/gtest.h>

#include "Base/error.h"
#include "FoamSim/web/frame_fields.h"
#include "small_run.h"

namespace foamsim::web {
namespace {

namespace fs = std::filesystem;
using test::SmallRun;

std::string refusal(const fs::path& folder) {
  try {
    read_run(folder);
  } catch (const base::InputError& error) {
    return error.what();
  }
  return {};
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(RunContents, WantsAFolderWithARun) {
  const ::test::ScratchFolder empty;
  EXPECT_TRUE(has(refusal(empty.path() / "no"), "is not a folder"));
  EXPECT_TRUE(has(refusal(empty.path()), "it has no run.json"));
  const SmallRun damaged;
  damaged.write("run.json", "{\"scene\":");
  EXPECT_TRUE(has(refusal(damaged.path()), "run.json' is damaged"));
  const SmallRun bare;
  fs::remove_all(bare.path() / "frames");
  EXPECT_TRUE(has(refusal(bare.path()), "has no frames"));
}

TEST(RunContents, SaysWhichFramesAreMissingInTheMiddle) {
  const SmallRun run;
  fs::remove(run.frame(2));
  fs::remove(run.frame(4));
  EXPECT_TRUE(has(refusal(run.path()), "lacks frames between steps 0 and 6, where there is one every 2"));
  const SmallRun with_fields(true);
  fs::remove(with_fields.fields(4));
  EXPECT_TRUE(has(refusal(with_fields.path()), "vtp' lacks the frame of step 4"));
}

TEST(RunContents, OfARunThatGoesOnLeaveOutWhatIsBeingWritten) {
  const SmallRun run(true);
  run.write("run.json", R"({"scene": "two", "dt": 0.5, "ended": "running", "options": {"frame_every": 2}})");
  fs::remove(run.fields(6));
  run.write("metrics.csv", "step,time,area\n0,0,1.5\n2,1,1.75\n4,2,2\n6,");
  const RunContents contents = read_run(run.path());
  EXPECT_TRUE(contents.is_running());
  ASSERT_EQ(contents.frames.size(), 3u);
  EXPECT_EQ(contents.frames.back().step, 4);
  EXPECT_EQ(contents.metrics.rows.size(), 3u);
}

TEST(RunContents, SayWhichRowOfATableIsNone) {
  const SmallRun run;
  run.write("metrics.csv", "step,time\n0,0\n2,soon\n");
  EXPECT_TRUE(has(refusal(run.path()), "metrics.csv, line 3: 'soon' is not a number"));
  run.write("metrics.csv", "step,time\n0,0,0\n");
  EXPECT_TRUE(has(refusal(run.path()), "line 2: 3 cells in place of 2"));
}

TEST(RunContents, NeedNoTables) {
  const SmallRun run;
  for (const char* table : {"metrics.csv", "volumes.csv", "events.csv"}) fs::remove(run.path() / table);
  const RunContents contents = read_run(run.path());
  EXPECT_EQ(contents.frames.size(), 4u);
  EXPECT_EQ(contents.frames[1].time, 1.0);  // by dt
}

TEST(FrameFields, ThatDoNotExistAreRefusedWithThoseThatDo) {
  const std::vector<FrameField> fields{{"height", true, {}}, {"flow", false, {}}};
  try {
    chosen_fields(fields, {"hieght"});
    FAIL();
  } catch (const base::InputError& error) {
    EXPECT_TRUE(has(error.what(), "unknown field 'hieght'; did you mean 'height'")) << error.what();
  }
}

TEST(SpreadIndices, HaveTheFirstAndTheLast) {
  EXPECT_EQ(spread_indices(3, 10), (std::vector<std::size_t>{0, 1, 2}));
  EXPECT_EQ(spread_indices(101, 3), (std::vector<std::size_t>{0, 50, 100}));
  EXPECT_TRUE(spread_indices(0, 3).empty());
}

}  // namespace
}  // namespace foamsim::web
