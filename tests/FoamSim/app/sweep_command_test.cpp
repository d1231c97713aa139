#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "program.h"

namespace foamsim::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

// The rows of a sweep's table by the run's name, each by column.
std::map<std::string, std::map<std::string, std::string>> sweep_table(const fs::path& folder) {
  const auto cells_of = [](const std::string& line) {
    std::vector<std::string> cells(1);
    for (const char c : line)
      if (c == ',')
        cells.emplace_back();
      else
        cells.back() += c;
    return cells;
  };
  std::istringstream in(read_file(folder / "table.csv"));
  std::string line;
  std::getline(in, line);
  const auto columns = cells_of(line);
  std::map<std::string, std::map<std::string, std::string>> rows;
  while (std::getline(in, line)) {
    const auto cells = cells_of(line);
    EXPECT_EQ(cells.size(), columns.size()) << line;
    std::map<std::string, std::string> row;
    for (std::size_t i = 0; i < std::min(cells.size(), columns.size()); ++i) row[columns[i]] = cells[i];
    rows[row["run"]] = row;
  }
  return rows;
}

// A grid of long runs: the program that makes it can be interrupted. Steps are counted in metrics.csv.
constexpr const char* long_grid =
    "scene = \"doublebubble\"\nsteps = 1000000\n[options]\nframe_every = 0\n[sweep]\nn = [8, 9]\n";

// Shell words that wait until this file has some rows, for half a minute at most.
std::string wait_for_rows(const std::string& file) {
  return "for i in $(seq 300); do [ \"$(wc -l <" + file +
         " 2>/dev/null || echo 0)\" -gt 5 ] && break; sleep 0.1; done; ";
}

TEST(SweepCommand, MakesAFolderForEachRunAndATable) {
  const ScratchFolder scratch;
  const std::string command = "sweep " FOAMSIM_SWEEPS "/bubbles.toml --workers 2 --out " + (scratch / "out");
  const ProgramResult result = run_foamsim(command);
  ASSERT_EQ(result.exit_code, 0) << result.error;
  EXPECT_NE(result.out.find("4 runs: 4 finished; table in "), std::string::npos) << result.out;
  auto rows = sweep_table(scratch / "out");
  ASSERT_EQ(rows.size(), 4U);
  for (const char* n : {"8", "12"})
    for (const char* area : {"naive", "averaged"}) {
      auto& row = rows[std::string("n=") + n + "_area=" + area];
      EXPECT_EQ(row["n"], n);
      EXPECT_EQ(row["area"], area);
      EXPECT_EQ(row["status"], "finished");
      EXPECT_EQ(row["exit_code"], "0");
      EXPECT_EQ(row["last_step"], "10");
      EXPECT_EQ(row["last.step"], "10");
      EXPECT_GT(std::stod(row["last.energy"]), 0);
      EXPECT_TRUE(fs::exists(scratch.path() / "out/runs" / row["run"] / "frames/frame_000010.ply"));
    }
  EXPECT_NE(rows["n=8_area=naive"]["last.energy"], rows["n=8_area=averaged"]["last.energy"]);

  // A second time nothing is made again.
  const auto when = fs::last_write_time(scratch / "out/runs/n=8_area=naive/run.json");
  EXPECT_EQ(run_foamsim(command).exit_code, 0);
  EXPECT_EQ(fs::last_write_time(scratch / "out/runs/n=8_area=naive/run.json"), when);
  // One that was taken away is.
  fs::remove_all(scratch / "out/runs/n=8_area=naive");
  EXPECT_EQ(run_foamsim("sweep --out " + (scratch / "out")).exit_code, 0);
  EXPECT_TRUE(fs::exists(scratch / "out/runs/n=8_area=naive/run.json"));
}

TEST(SweepCommand, AFailedRunIsARowWithItsMessage) {
  const ScratchFolder scratch;
  std::ofstream(scratch / "grid.toml") << "scene = \"doublebubble\"\nsteps = 2\n[options]\neffects = "
                                          "[\"surface_tension\", \"burst\"]\n[sweep]\nburst_region = [[1], [7]]\n";
  const std::string command = "sweep " + (scratch / "grid.toml") + " --out " + (scratch / "out");
  const ProgramResult result = run_foamsim(command);
  EXPECT_EQ(result.exit_code, 3) << result.error;
  EXPECT_NE(result.out.find("failed: burst_region=7: burst_region names region 7"), std::string::npos) << result.out;
  auto rows = sweep_table(scratch / "out");
  EXPECT_EQ(rows["burst_region=1"]["status"], "finished");
  EXPECT_EQ(rows["burst_region=7"]["status"], "failed");
  EXPECT_EQ(rows["burst_region=7"]["exit_code"], "2");
  EXPECT_EQ(rows["burst_region=7"]["message"].find("burst_region names region 7"), 0U);
  EXPECT_EQ(run_foamsim(command + " --retry").exit_code, 3);
}

TEST(SweepCommand, InterruptedSavesItsRunsAndTheNextGoesOn) {
  const ScratchFolder scratch;
  std::ofstream(scratch / "grid.toml") << long_grid;
  const std::string first = scratch / "out/runs/n=8";
  const std::string sweep = " sweep " + (scratch / "grid.toml") + " --workers 2 --out " + (scratch / "out");
  const std::string interrupted = "& pid=$!; " + wait_for_rows(first + "/metrics.csv") +
                                  wait_for_rows(scratch / "out/runs/n=9/metrics.csv") + "kill -TERM $pid; wait $pid";
  std::ofstream(scratch / "script") << FOAMSIM_PROGRAM << sweep << interrupted << "\n";
  EXPECT_EQ(::test::run_program("sh", scratch / "script").exit_code, 143);
  auto rows = sweep_table(scratch / "out");
  ASSERT_EQ(rows.size(), 2U);
  for (auto& [name, row] : rows) {
    EXPECT_EQ(row["status"], "interrupted") << name;
    EXPECT_EQ(row["exit_code"], "143") << name;
    EXPECT_TRUE(fs::exists(scratch.path() / "out/runs" / name / "checkpoint.cbor")) << name;
  }
  const long done = std::stol(rows["n=8"]["last_step"]);
  EXPECT_GT(done, 0);
  // It goes on behind the last step and is interrupted once more.
  std::ofstream(scratch / "script") << FOAMSIM_PROGRAM << sweep << "& pid=$!; for i in $(seq 300); do grep -q "
                                    << "'\"first_step\": " << done << "' " << first
                                    << "/run.json && break; sleep 0.1; done; kill -TERM $pid; wait $pid\n";
  EXPECT_EQ(::test::run_program("sh", scratch / "script").exit_code, 143);
  EXPECT_EQ(json::parse(read_file(first + "/run.json"))["first_step"], done);
}

TEST(SweepCommand, KilledLeavesRunsThatTheNextDoesNotStartTwice) {
  const ScratchFolder scratch;
  std::ofstream(scratch / "grid.toml") << "scene = \"doublebubble\"\nsteps = 1000000\n[sweep]\nn = [8]\n";
  const std::string run = scratch / "out/runs/n=8";
  const std::string sweep = " sweep " + (scratch / "grid.toml") + " --out " + (scratch / "out");
  std::ofstream(scratch / "script") << FOAMSIM_PROGRAM << sweep << "& pid=$!; " << wait_for_rows(run + "/metrics.csv")
                                    << "kill -KILL $pid; wait $pid\n";
  ::test::run_program("sh", scratch / "script");
  const ProgramResult second = run_foamsim(sweep);
  EXPECT_EQ(second.exit_code, 5) << second.error;
  EXPECT_NE(second.out.find("1 runs: 1 running"), std::string::npos) << second.out;
  // The run that is left over, which nobody waits for, saves when it is asked to.
  std::ofstream(scratch / "end")
      << "for p in /proc/[0-9]*; do tr '\\0' ' ' <$p/cmdline 2>/dev/null | grep -q -- '--out " << run
      << " ' && id=${p#/proc/}; done; kill -TERM $id; "
      << "for i in $(seq 300); do grep -q interrupted " << run << "/run.json && break; sleep 0.1; done; sleep 0.5\n";
  ::test::run_program("sh", scratch / "end");
  EXPECT_EQ(run_foamsim("sweep --collect --out " + (scratch / "out")).exit_code, 5);
  EXPECT_EQ(sweep_table(scratch / "out")["n=8"]["status"], "interrupted");
}

TEST(SweepCommand, ListsCommandsForOthersToRun) {
  const ScratchFolder scratch;
  const std::string out = scratch / "out";
  const std::string list = "sweep " FOAMSIM_SWEEPS "/bubbles.toml --list --out " + out;
  const ProgramResult listed = run_foamsim(list);
  ASSERT_EQ(listed.exit_code, 0) << listed.error;
  EXPECT_EQ(std::ranges::count(listed.out, '\n'), 4);
  EXPECT_FALSE(fs::exists(scratch.path() / "out/runs/n=8_area=naive"));
  EXPECT_EQ(run_foamsim("sweep --collect --out " + out).exit_code, 5);
  EXPECT_EQ(sweep_table(out)["n=8_area=naive"]["status"], "pending");
  std::ofstream(scratch / "script") << FOAMSIM_PROGRAM " " << list << " | xargs -d '\\n' -n 1 -P 2 sh -c\n";
  const ProgramResult made = ::test::run_program("sh", scratch / "script");
  EXPECT_EQ(made.exit_code, 0) << made.error;
  EXPECT_EQ(run_foamsim("sweep --collect --out " + out).exit_code, 0);
  EXPECT_EQ(sweep_table(out)["n=12_area=averaged"]["status"], "finished");
  EXPECT_EQ(run_foamsim(list).out, "");
}

TEST(SweepCommand, ListsCommandsForGnuParallel) {
  if (::test::run_program("parallel", "--version").exit_code != 0) GTEST_SKIP() << "GNU parallel is not installed";
  const ScratchFolder scratch;
  const std::string out = scratch / "out";
  std::ofstream(scratch / "script") << FOAMSIM_PROGRAM " sweep " FOAMSIM_SWEEPS "/bubbles.toml --list --out " << out
                                    << " | parallel -j 2\n";
  EXPECT_EQ(::test::run_program("sh", scratch / "script").exit_code, 0);
  EXPECT_EQ(run_foamsim("sweep --collect --out " + out).exit_code, 0);
}

// Text of a grid file that has to be refused, with parts of the message.
struct BadGrid {
  std::string name, text;
  std::vector<std::string> message_has;
  std::string more = {};
};

class BadSweep : public testing::TestWithParam<BadGrid> {};

TEST_P(BadSweep, IsOneLineThatHelpsAndLeavesNothing) {
  const ScratchFolder scratch;
  std::ofstream(scratch / "grid.toml") << GetParam().text;
  ::test::expect_refused(FOAMSIM_PROGRAM,
                         {"", "sweep " + (scratch / "grid.toml") + " " + GetParam().more, GetParam().message_has});
}

const std::string bubble = "scene = \"doublebubble\"\n";

INSTANTIATE_TEST_SUITE_P(
    Grids, BadSweep,
    testing::Values(
        BadGrid{"no_toml", "scene = = 3\n", {"grid.toml:1", "not valid TOML"}},
        BadGrid{"no_scene", "[sweep]\nn = [8]\n", {"needs scene ="}},
        BadGrid{"unknown_scene", "scene = \"doublebuble\"\n[sweep]\nn = [8]\n", {"grid.toml:1", "'doublebubble'"}},
        BadGrid{"missing_scene_file", "scene = \"no.toml\"\n[sweep]\nn = [8]\n", {"grid.toml:1", "no such scene file"}},
        BadGrid{"unknown_key", bubble + "stepz = 3\n[sweep]\nn = [8]\n", {"grid.toml:2", "did you mean 'steps'"}},
        BadGrid{"steps_not_whole", bubble + "steps = 3.5\n[sweep]\nn = [8]\n", {"grid.toml:2", "whole number"}},
        BadGrid{"no_sweep", bubble, {"needs a table [sweep]"}},
        BadGrid{"sweep_is_no_table", bubble + "sweep = 3\n", {"grid.toml:2", "[sweep]"}},
        BadGrid{"no_list", bubble + "[sweep]\nn = 8\n", {"grid.toml:3", "list of values"}},
        BadGrid{"empty_list", bubble + "[sweep]\nn = []\n", {"grid.toml:3", "list of n is empty"}},
        BadGrid{"value_twice", bubble + "[sweep]\ndt = [1, 1.0]\n", {"grid.toml:3", "twice"}},
        BadGrid{"unknown_option", bubble + "[sweep]\nn = [8]\nsigmaa = [1]\n", {"grid.toml:4", "'sigma'"}},
        BadGrid{"unknown_fixed_option", bubble + "[options]\nsigmaa = 1\n[sweep]\nn = [8]\n", {"grid.toml:3", "sigma"}},
        BadGrid{"bad_value_at_the_end", bubble + "[sweep]\nn = [8,\n12,\n7]\n", {"grid.toml:5", "n = 7"}},
        BadGrid{"bad_word", bubble + "[sweep]\narea = [\"naive\", \"avraged\"]\n", {"grid.toml:3", "'averaged'"}},
        BadGrid{"options_that_do_not_go_together",
                bubble + "[options]\nphi = 0.75\n[sweep]\narea = [\"constant-edge\", \"naive\"]\n",
                {"run area=naive", "phi"}},
        BadGrid{"too_many",
                bubble + "[sweep]\nseed = [" +
                    [] {
                      std::string list;
                      for (int i = 0; i < 1001; ++i) list += std::to_string(i) + ",";
                      return list;
                    }() +
                    "]\nn = [8, 9]\n",
                {"2002 runs", "--yes"}},
        BadGrid{"no_workers", bubble + "[sweep]\nn = [8]\n", {"--workers"}, "--workers 0"},
        BadGrid{"ways_that_exclude_each_other", bubble + "[sweep]\nn = [8]\n", {"--list", "--slurm"}, "--list --slurm"},
        BadGrid{"partition_without_slurm", bubble + "[sweep]\nn = [8]\n", {"--slurm"}, "--partition main"}),
    [](const auto& info) { return info.param.name; });

TEST(BadSweepFolder, OfAnotherGridIsRefused) {
  const ScratchFolder scratch;
  std::ofstream(scratch / "a.toml") << bubble << "steps = 0\n[sweep]\nn = [8]\n";
  std::ofstream(scratch / "b.toml") << bubble << "steps = 0\n[sweep]\nn = [8, 9]\n";
  const std::string out = " --out " + (scratch / "out");
  ASSERT_EQ(run_foamsim("sweep " + (scratch / "a.toml") + out).exit_code, 0);
  const ProgramResult other = run_foamsim("sweep " + (scratch / "b.toml") + out);
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_NE(other.error.find("another grid"), std::string::npos) << other.error;
  EXPECT_FALSE(fs::exists(scratch.path() / "out/runs/n=9"));
  const ProgramResult missing = run_foamsim("sweep --collect --out " + (scratch / "nowhere"));
  EXPECT_EQ(missing.exit_code, 2);
  EXPECT_NE(missing.error.find("holds no sweep"), std::string::npos) << missing.error;
  EXPECT_EQ(run_foamsim("sweep --run n=77" + out).exit_code, 2);
  EXPECT_EQ(run_foamsim("sweep --task 1" + out).exit_code, 2);
}

}  // namespace
}  // namespace foamsim::test
