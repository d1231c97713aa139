#include "FoamSim/studies/reproduce/figure1.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "Base/error.h"
#include "tests/support/scratch_folder.h"

namespace foamsim {
namespace {

namespace fs = std::filesystem;

TEST(Figure1, RunsTheThreeStrategiesAndOursWithAsManyFramesAsAreDrawn) {
  const ::test::ScratchFolder scratch;
  RunSettings settings;
  settings.out = scratch.path() / "figure1";
  const auto runs =
      run_figure1({.n = 12, .time = 0.08, .frames = 4}, settings, [](const std::string&) { return RunHooks(); });
  ASSERT_EQ(runs.size(), 4u);
  for (const ComparedRun& run : runs) {
    EXPECT_EQ(run.outcome.end, RunEnd::finished) << run.area;
    EXPECT_EQ(std::distance(fs::directory_iterator(run.outcome.directory / "frames"), fs::directory_iterator()), 5);
  }
  const auto options_of = [&settings](const char* area) {
    return nlohmann::json::parse(std::ifstream(settings.out / area / "run.json")).at("options");
  };
  EXPECT_EQ(options_of("constant-edge").at("phi"), 0.75) << "the published program's";
  for (const char* area : {"naive", "constant-edge", "averaged"}) {
    EXPECT_EQ(options_of(area).at("area"), area);
    EXPECT_EQ(options_of(area).at("diffusion"), 10);
  }
  const auto rows = read_comparison(settings.out / "compare.csv");
  ASSERT_EQ(rows.size(), 4u);
  EXPECT_EQ(rows.back().area, "conservative");
  EXPECT_DOUBLE_EQ(drift_ratio(rows, "averaged"), rows[0].centroid_drift / rows[2].centroid_drift);
}

TEST(Figure1, NeedsBothStrategiesForARatio) {
  std::vector<ComparisonRow> rows(2);
  rows[0].area = "naive";
  rows[0].centroid_drift = 0.9;
  rows[1].area = "averaged";
  rows[1].centroid_drift = 0.1;
  EXPECT_NEAR(drift_ratio(rows, "averaged"), 9, 1e-12);
  EXPECT_THROW(drift_ratio(rows, "constant-edge"), base::InputError);
}

}  // namespace
}  // namespace foamsim
