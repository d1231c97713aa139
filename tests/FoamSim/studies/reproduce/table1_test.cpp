// The table's book-keeping, on runs of a few steps.
#include "FoamSim/studies/reproduce/table1.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "Base/error.h"
#include "FoamSim/studies/reproduce/table1_csv.h"

namespace foamsim {
namespace {

namespace fs = std::filesystem;

class Table1Test : public testing::Test {
 public:
  ~Table1Test() override { fs::remove_all(settings.out); }

 protected:
  Table1Test() {
    settings.subdivisions = {8, 10};
    settings.areas = {"averaged", "naive"};
    settings.longest_time = 0.03;
    settings.out = fs::path(testing::TempDir()) / ("foamsim-table1-" + std::to_string(getpid()));
    fs::remove_all(settings.out);
    hooks.run = [this](const std::string& area, long n, double begin, double end) {
      runs.push_back(area + std::to_string(n));
      EXPECT_LE(share, begin + 1e-12);
      EXPECT_LT(begin, end);
      share = end;
      return RunHooks{{}, [this] { return runs.size() == interrupt_in_run; }};
    };
    hooks.row = [this](const Table1Row& row) { reported.push_back(row.area); };
  }

  Table1Settings settings;
  Table1Hooks hooks;
  std::vector<std::string> runs, reported;
  double share = 0;
  std::size_t interrupt_in_run = 0;
};

TEST_F(Table1Test, HasARowForEveryCaseCoarseFirst) {
  const auto rows = make_table1(settings, hooks);
  EXPECT_EQ(runs, (std::vector<std::string>{"averaged8", "naive8", "averaged10", "naive10"}));
  EXPECT_NEAR(share, 1, 1e-12);
  EXPECT_EQ(reported.size(), 4U);
  ASSERT_EQ(rows.size(), 4U);
  EXPECT_EQ(rows[0].ended, "not at rest") << "and the row says so";
  EXPECT_EQ(rows[0].steps, 3);
  EXPECT_NEAR(rows[0].time, 0.03, 1e-12);
  EXPECT_GT(rows[0].triangles_start, 0);
  EXPECT_GT(rows[0].exact_facets_deg, 1);
  EXPECT_FALSE(rows[0].published_deg) << "the report has no such resolution";
}

TEST_F(Table1Test, AnInterruptedTableGoesOnWhereItStopped) {
  interrupt_in_run = 3;
  EXPECT_EQ(make_table1(settings, hooks).size(), 2U);
  EXPECT_EQ(read_table1(settings.out / "table1.csv").size(), 2U);
  runs.clear();
  share = 0;
  interrupt_in_run = 0;
  EXPECT_EQ(make_table1(settings, hooks).size(), 4U);
  EXPECT_EQ(runs, (std::vector<std::string>{"averaged10", "naive10"}));
  EXPECT_NEAR(share, 1, 1e-12);
}

TEST_F(Table1Test, IsMadeAnewWhenForced) {
  make_table1(settings, hooks);
  runs.clear();
  share = 0;
  settings.force = true;
  settings.subdivisions = {8};
  EXPECT_EQ(make_table1(settings, hooks).size(), 2U);
  EXPECT_EQ(runs.size(), 2U);
}

TEST_F(Table1Test, ReadsWhatItWrites) {
  Table1Row row;
  row.area = "averaged";
  row.n = 16;
  row.triangles = 1058;
  row.angle_rms_deg = 11.74;
  row.published_deg = 12.79;
  row.exact_facets_deg = 5.8;
  row.border_height = 0.25;
  row.steps = 1136;
  row.cpu_seconds = 12.5;
  row.ended = "at rest";
  fs::create_directories(settings.out);
  write_table1(settings.out / "t.csv", {row});
  const Table1Row read = read_table1(settings.out / "t.csv").at(0);
  EXPECT_EQ(read.n, 16);
  EXPECT_EQ(read.triangles, 1058);
  EXPECT_EQ(*read.angle_rms_deg, 11.74);
  EXPECT_FALSE(read.angle_rms_film_deg);
  EXPECT_NEAR(read.difference_deg().value(), -1.05, 1e-12);
  EXPECT_EQ(read.exact_facets_deg, 5.8);
  EXPECT_EQ(read.border_height, 0.25);
  EXPECT_EQ(read.steps, 1136);
  EXPECT_EQ(read.cpu_seconds, 12.5);
  EXPECT_EQ(read.ended, "at rest");
}

TEST_F(Table1Test, ADamagedTableIsAnErrorThatNamesTheLine) {
  fs::create_directories(settings.out);
  write_table1(settings.out / "table1.csv", {Table1Row()});
  std::ofstream(settings.out / "table1.csv", std::ios::app) << "averaged,16\n";
  try {
    make_table1(settings, hooks);
    FAIL();
  } catch (const base::InputError& error) {
    EXPECT_NE(std::string(error.what()).find("table1.csv:3"), std::string::npos) << error.what();
  }
}

TEST(ObservedOrder, IsTheSlopeInTheResolution) {
  Table1Row coarse, fine;
  coarse.n = 16;
  fine.n = 32;
  coarse.angle_rms_deg = 12;
  fine.angle_rms_deg = 3;
  EXPECT_NEAR(observed_order(coarse, fine).value(), 2, 1e-12);
  fine.angle_rms_deg.reset();
  EXPECT_FALSE(observed_order(coarse, fine));
}

}  // namespace
}  // namespace foamsim
