#include "FoamSim/sweep/grid.h"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "Base/error.h"
#include "FoamSim/sweep/plan.h"
#include "FoamSim/sweep/slurm.h"
#include "tests/support/scratch_folder.h"

namespace foamsim::sweep {
namespace {

using ::test::ScratchFolder;

Grid grid_of(const std::string& text) {
  const ScratchFolder scratch;
  std::ofstream(scratch / "grid.toml") << text;
  return read_grid(scratch / "grid.toml", built_in_catalogue());
}

TEST(Grid, HoldsWhatTheFileSaysInItsOrder) {
  const Grid grid = grid_of(
      "scene = \"doublebubble\"\nsteps = 3\n[options]\nsigma = 2\nremeshing.enabled = false\n"
      "[sweep]\nn = [8, 12]\narea = [\"naive\", \"averaged\"]\ndt = [0.5, 1]\n");
  EXPECT_EQ(grid.scene, "doublebubble");
  EXPECT_EQ(grid.fixed, (std::vector<std::string>{"sigma=2", "remeshing.enabled=false"}));
  EXPECT_EQ(grid.steps, 3);
  const std::vector<Axis> axes{{"n", {"8", "12"}}, {"area", {"naive", "averaged"}}, {"dt", {"0.5", "1"}}};
  EXPECT_EQ(grid.axes, axes);
  EXPECT_EQ(grid_from_json(to_json(grid)), grid);
}

TEST(Grid, RunsAreEveryCombinationOnce) {
  const Grid grid = grid_of(
      "scene = \"doublebubble\"\n[sweep]\nn = [8, 12]\nseed = [1, 2, 3]\n"
      "effects = [[\"surface_tension\"], [\"surface_tension\", \"diffusion\"]]\n");
  const std::vector<PlannedRun> runs = plan_runs(grid);
  ASSERT_EQ(runs.size(), 12U);
  EXPECT_EQ(runs.front().name, "n=8_seed=1_effects=surface_tension");
  EXPECT_EQ(runs.back().name, "n=12_seed=3_effects=surface_tension+diffusion");
  std::set<std::string> names;
  for (const PlannedRun& run : runs) names.insert(run.name);
  EXPECT_EQ(names.size(), runs.size());
  const std::vector<std::string> arguments{"run",   "doublebubble", "--set", "n=12",
                                           "--set", "seed=3",       "--set", "effects=surface_tension,diffusion"};
  EXPECT_EQ(run_arguments(grid, runs.back()), arguments);
}

TEST(Grid, NamesThatDoNotFitStayDifferent) {
  Grid grid{.scene = "sphere"};
  grid.axes = {{"blow_where", {"x > 0", "x < 0", "../up"}}, {"wires", {std::string(300, 'a'), std::string(301, 'a')}}};
  std::set<std::string> names;
  for (const PlannedRun& run : plan_runs(grid)) {
    EXPECT_LT(run.name.size(), 200U);
    EXPECT_EQ(run.name.find_first_of("/ <>"), std::string::npos) << run.name;
    names.insert(run.name);
  }
  EXPECT_EQ(names.size(), 6U);
}

TEST(Grid, IsCountedWithoutOverflow) {
  Grid grid{.scene = "sphere"};
  grid.axes.assign(3, {"n", std::vector<std::string>(100, "1")});
  EXPECT_EQ(count_runs(grid), 1'000'000U);
  grid.axes.assign(40, {"n", std::vector<std::string>(100, "1")});
  EXPECT_EQ(count_runs(grid), most_runs_counted);
  EXPECT_THROW(plan_runs(grid), base::InputError);
}

TEST(Grid, SceneFilesAreRelativeToTheGridAndTheirBytesBelongToIt) {
  const ScratchFolder scratch;
  std::ofstream(scratch / "mine.toml") << "scene = \"sphere\"\nsigma = 2\n";
  std::ofstream(scratch / "grid.toml") << "scene = \"mine.toml\"\n[sweep]\nn = [1, 2]\n";
  const Grid before = read_grid(scratch / "grid.toml", built_in_catalogue());
  EXPECT_EQ(before.scene, scratch / "mine.toml");
  std::ofstream(scratch / "mine.toml") << "scene = \"sphere\"\nsigma = 3\n";
  EXPECT_NE(read_grid(scratch / "grid.toml", built_in_catalogue()), before);
}

TEST(Slurm, IndicesOfAnArrayAreRanges) {
  EXPECT_EQ(array_indices({0, 1, 2, 3}), "0-3");
  EXPECT_EQ(array_indices({2}), "2");
  EXPECT_EQ(array_indices({0, 2, 3, 7, 8, 9}), "0,2-3,7-9");
}

TEST(ShellWord, IsReadBackAsItWas) {
  EXPECT_EQ(shell_quoted("out/n=8_area=naive"), "out/n=8_area=naive");
  EXPECT_EQ(shell_quoted("my folder"), "'my folder'");
  EXPECT_EQ(shell_quoted("it's"), "'it'\\''s'");
}

TEST(Grid, AnAxisWithMoreValuesThanASweepHasRunsIsRefused) {
  std::string text = "scene = \"doublebubble\"\n[sweep]\nn = [8";
  for (std::size_t i = 0; i < most_runs; ++i) text += ",\n8";
  try {
    grid_of(text + "]\n");
    ADD_FAILURE() << "accepted";
  } catch (const base::InputError& error) {
    EXPECT_NE(std::string(error.what()).find("grid.toml:3: n has 100001 values"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace foamsim::sweep
