// foamsim study accuracy and stability: what they write and print, and Surface Evolver's curve beside them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <sstream>

#include "program.h"

namespace foamsim::test {
namespace {

namespace fs = std::filesystem;

std::vector<std::vector<std::string>> table(const fs::path& file) {
  std::istringstream in(read_file(file));
  std::vector<std::vector<std::string>> rows;
  for (std::string line, cell; std::getline(in, line);) {
    rows.emplace_back();
    for (std::istringstream cells(line); std::getline(cells, cell, ',');) rows.back().push_back(cell);
  }
  return rows;
}

const char* const tiny =
    " --areas averaged --sizes 8 --integrators euler --dt 0.04 --time 0.4 --no-evolver --quiet --out ";

TEST(StudyAccuracy, WritesARowForEachRunAndItsPlots) {
  const ScratchFolder scratch;
  const ProgramResult result = run_foamsim(std::string("study accuracy") + tiny + (scratch / "a"));
  ASSERT_EQ(result.exit_code, 0) << result.error;
  const auto rows = table(scratch / "a/accuracy.csv");
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0][0], "area");
  EXPECT_EQ(rows[1][0], "averaged");
  EXPECT_EQ(rows[1][5], "10") << "steps";
  EXPECT_FALSE(fs::exists(scratch / "a/evolver.csv"));
  EXPECT_EQ(run_foamsim(std::string("study accuracy") + tiny + (scratch / "a")).exit_code, 2) << "it holds a study";
  EXPECT_EQ(run_foamsim(std::string("study accuracy --force") + tiny + (scratch / "a")).exit_code, 0);
}

const char* const two_rows =
    "study accuracy --areas naive,averaged --sizes 8 --integrators euler --dt 0.04 --time 0.4 --no-evolver --quiet "
    "--out ";

TEST(StudyOfSeveralRows, MakesOnlyTheRowsThatItDoesNotHave) {
  const ScratchFolder scratch;
  const std::string out = scratch / "a", row = out + "/runs/sizes=8_areas=naive_integrators=euler_dt=0.04";
  ASSERT_EQ(run_foamsim(two_rows + out).exit_code, 0);
  const auto rows = table(out + "/accuracy.csv");
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[1][0], "naive");
  EXPECT_EQ(rows[2][0], "averaged");
  // The seconds would differ if a row were made again.
  fs::remove(out + "/accuracy.csv");
  ASSERT_EQ(run_foamsim(two_rows + out).exit_code, 0);
  EXPECT_EQ(table(out + "/accuracy.csv"), rows);
  fs::remove_all(row);
  ASSERT_EQ(run_foamsim(two_rows + out).exit_code, 0);
  EXPECT_EQ(table(out + "/accuracy.csv")[2], rows[2]);
  EXPECT_NE(table(out + "/accuracy.csv")[1], rows[1]);
  EXPECT_EQ(run_foamsim(std::string("study accuracy") + tiny + out).exit_code, 2) << "it holds another study";
}

TEST(StudyOfSeveralRows, IsASweepThatIsMadeElsewhere) {
  const ScratchFolder scratch;
  const std::string out = scratch / "a";
  ASSERT_EQ(run_foamsim(std::string(two_rows) + out + " --plan").exit_code, 0);
  EXPECT_TRUE(fs::is_empty(out + "/runs"));
  const ProgramResult list = run_foamsim("sweep --list --out " + out);
  EXPECT_EQ(std::ranges::count(list.out, '\n'), 2) << list.out;
  ASSERT_EQ(run_foamsim("sweep --quiet --out " + out).exit_code, 0);
  const auto rows = table(out + "/table.csv");
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_NE(std::ranges::find(rows[0], "last.area_error"), rows[0].end());
  const ProgramResult gathered = run_foamsim(two_rows + out);
  EXPECT_EQ(gathered.exit_code, 0) << gathered.error;
  EXPECT_EQ(table(out + "/accuracy.csv").size(), 3U);
}

TEST(StudyStability, PrintsVerdictsAndGoesOnAfterFailures) {
  const ScratchFolder scratch;
  const ProgramResult result = run_foamsim(
      "study stability --cases quad-point,shrinking,scaled --steps-scale 0.05 --areas averaged --remeshing on "
      "--case-seconds 20 --quiet --out " +
      (scratch / "s"));
  ASSERT_EQ(result.exit_code, 0) << result.error;
  const auto rows = table(scratch / "s/stability.csv");
  ASSERT_EQ(rows.size(), 4U);
  EXPECT_EQ(rows[3][0], "scaled");
  EXPECT_EQ(rows[3][3], "pass");
  EXPECT_NE(result.out.find("of 3 passed"), std::string::npos) << result.out;
}

TEST(StudyStability, NamesItsCases) {
  const ProgramResult result = run_foamsim("study stability --list");
  EXPECT_EQ(result.exit_code, 0);
  for (const char* name : {"long", "volume-ratio", "time-steps", "meeting", "foam"})
    EXPECT_NE(result.out.find(name), std::string::npos) << name;
}

TEST(Studies, RefuseBadInputBeforeTheyWrite) {
  const ScratchFolder scratch;
  for (const std::string bad :
       {"accuracy --sizes 7", "accuracy --areas averged", "accuracy --integrators rk5", "accuracy --dt 0",
        "accuracy --quick --sizes 8", "stability --cases lnog", "stability --areas none", "stability --remeshing maybe",
        "stability --steps-scale 0", "stability --case-seconds -1", "stability --set inertai=false",
        "stability --areas averaged --set inertia=false"}) {
    const ProgramResult result = run_foamsim("study " + bad + " --out " + (scratch / "bad"));
    EXPECT_EQ(result.exit_code, 2) << bad;
    EXPECT_NE(result.error, "") << bad;
    EXPECT_FALSE(fs::exists(scratch / "bad")) << bad;
  }
}

int measure_evolver(const std::string& environment, const ScratchFolder& scratch) {
  const std::string command =
      environment + " /usr/bin/python3 " FOAMSIM_EVOLVER_SCRIPT " " + scratch.path().string() + " 3 >/dev/null 2>&1";
  return std::system(command.c_str());
}

TEST(EvolverScript, LeavesTheCurveOutWhereEvolverIsNotInstalled) {
  if (!fs::exists("/usr/bin/python3")) GTEST_SKIP() << "no /usr/bin/python3";
  const ScratchFolder scratch;
  EXPECT_EQ(measure_evolver("PATH=/nonexistent", scratch), 0);
  EXPECT_TRUE(fs::is_empty(scratch.path()));
}

// An independent program against the closed form: linear elements are of second order in area, first in angle.
TEST(EvolverScript, ConvergesToTheClosedForm) {
  if (!fs::exists("/usr/bin/evolver") || !fs::exists("/usr/bin/python3")) GTEST_SKIP() << "evolver is not installed";
  const ScratchFolder scratch;
  ASSERT_EQ(measure_evolver("", scratch), 0);
  const auto rows = table(scratch / "evolver.csv");
  ASSERT_EQ(rows.size(), 4U);
  auto number = [&rows](std::size_t row, std::size_t column) { return std::stod(rows[row][column]); };
  for (std::size_t level = 2; level < 4; ++level) {
    EXPECT_EQ(number(level, 1), 4 * number(level - 1, 1));
    EXPECT_NEAR(number(level - 1, 2) / number(level, 2), 4, 0.5) << "area";
    EXPECT_NEAR(number(level - 1, 4) / number(level, 4), 2, 0.4) << "angles of the facets";
  }
  EXPECT_LT(std::abs(number(3, 3)), 0.005) << "pressure";
}

// Newton's method on the very mesh at which the conservative dynamics have come to rest.
TEST(EvolverScript, FindsNothingToWinWhereTheConservativeDynamicsRest) {
  if (!fs::exists("/usr/bin/evolver") || !fs::exists("/usr/bin/python3")) GTEST_SKIP() << "evolver is not installed";
  const ScratchFolder scratch;
  ASSERT_EQ(run_foamsim("run doublebubble --set dynamics=conservative --set n=12 --set dt=auto --set viscosity=0.1 "
                        "--set effects=surface_tension,volumes,damping --set damping=0.02 --set damping_from=3 --set "
                        "frame_every=0 --time 10 "
                        "--out " +
                        (scratch / "run"))
                .exit_code,
            0);
  std::string frame;
  for (const auto& entry : fs::directory_iterator(scratch / "run/frames"))
    frame = std::max(frame, entry.path().string());
  const std::string relaxed = scratch / "relaxed.ply",
                    script = (fs::path(FOAMSIM_EVOLVER_SCRIPT).parent_path() / "relax_in_evolver.py").string();
  ASSERT_EQ(std::system(("/usr/bin/python3 " + script + " " + frame + " " + relaxed + " >/dev/null 2>&1").c_str()), 0);
  const auto inspected = [](const std::string& file) {
    return nlohmann::json::parse(run_foamsim("inspect --json " + file).out);
  };
  const auto before = inspected(frame), after = inspected(relaxed);
  EXPECT_NEAR(after["area"].get<double>() / before["area"].get<double>(), 1, 2e-5);
  EXPECT_NEAR(after["angle_rms_deg"].get<double>(), before["angle_rms_deg"].get<double>(), 0.1);
}

}  // namespace
}  // namespace foamsim::test
