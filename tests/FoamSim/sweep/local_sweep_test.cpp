// Runs of a sweep whose program is a script, which ends in every way that there is.
#include "FoamSim/sweep/local_sweep.h"

#include <gtest/gtest.h>

#include <csignal>
#include <fstream>
#include <sstream>

#include "Base/error.h"
#include "Base/io/file_lock.h"
#include "FoamSim/sweep/table.h"
#include "tests/support/scratch_folder.h"

namespace foamsim::sweep {
namespace {

namespace fs = std::filesystem;
using ::test::ScratchFolder;

std::string text_of(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

// A sweep of the seeds 1, 2, ... with a program that does for each what `script` says; "$folder" is that of the run.
struct ScriptedSweep {
  ScriptedSweep(const std::string& script, int runs, int workers = 2) {
    std::ofstream(scratch / "program") << "#!/bin/sh\necho \"$*\" >>" << (scratch / "calls") << "\n"
                                       << "case \"$*\" in\n"
                                          "  *--resume*) folder=$(dirname \"$3\") ;;\n"
                                          "  *) words=\"$*\" folder=${words#*--out } folder=${folder%% *} ;;\n"
                                          "esac\n"
                                          "finish() { echo '{\"ended\": \"finished\"}' >$folder/run.json; }\n"
                                       << script << "\n";
    fs::permissions(scratch / "program", fs::perms::owner_all);
    Grid grid{.scene = "sphere", .steps = 5};
    grid.axes = {{"seed", {}}};
    for (int seed = 1; seed <= runs; ++seed) grid.axes[0].values.push_back(std::to_string(seed));
    sweep = sweep_in(scratch / "out", grid);
    write_sweep(sweep);
    settings = {.launcher = {.program = scratch / "program"}, .workers = workers};
  }

  std::vector<RunState> go(const LocalHooks& hooks = {}) {
    std::vector<RunState> states = states_of(sweep);
    std::vector<std::size_t> todo;
    for (std::size_t run = 0; run < states.size(); ++run)
      if (wants_start(states[run], settings.launcher.retry)) todo.push_back(run);
    run_locally(sweep, todo, settings, hooks, states);
    return states;
  }

  long calls() const {
    const std::string text = text_of(scratch / "calls");
    return std::ranges::count(text, '\n');
  }

  ScratchFolder scratch;
  Sweep sweep;
  LocalSettings settings;
};

TEST(LocalSweep, ACrashOfOneIsARowAndNotTheEndOfAll) {
  ScriptedSweep scripted("case $* in *seed=2*) echo 'program: about to fall' >&2; kill -SEGV $$ ;; *) finish ;; esac",
                         4);
  const auto states = scripted.go();
  for (const std::size_t run : {0U, 2U, 3U}) EXPECT_EQ(states[run].status, Status::finished) << run;
  EXPECT_EQ(states[1].status, Status::failed);
  EXPECT_EQ(states[1].exit_code, 128 + SIGSEGV);
  EXPECT_EQ(states[1].message, "ended by signal 11 (Segmentation fault): about to fall");
  write_table(scripted.sweep, states);
  EXPECT_NE(text_of(scripted.sweep.table()).find("\nseed=2,2,failed,139,ended by signal 11"), std::string::npos)
      << text_of(scripted.sweep.table());
}

TEST(LocalSweep, WhatIsDoneIsNotDoneAgainAndFailuresOnlyWhenAsked) {
  ScriptedSweep scripted("case $* in *seed=2*) echo 'program: no' >&2; exit 2 ;; *) finish ;; esac", 3);
  scripted.go();
  EXPECT_EQ(scripted.calls(), 3);
  EXPECT_EQ(scripted.go()[1].message, "no");
  EXPECT_EQ(scripted.calls(), 3);
  scripted.settings.launcher.retry = true;
  EXPECT_EQ(scripted.go()[1].status, Status::failed);
  EXPECT_EQ(scripted.calls(), 4);
}

TEST(LocalSweep, InterruptedRunsGoOnFromTheirCheckpoint) {
  ScriptedSweep scripted("case $* in *--resume*) finish ;; *) touch $folder/checkpoint.cbor; exit 143 ;; esac", 1);
  EXPECT_EQ(scripted.go()[0].status, Status::interrupted);
  EXPECT_EQ(scripted.go()[0].status, Status::finished);
  const std::string checkpoint = scripted.sweep.run_folder(0) / "checkpoint.cbor";
  EXPECT_NE(text_of(scripted.scratch / "calls").find("run --resume " + checkpoint + " --steps 5 --threads 1 --quiet\n"),
            std::string::npos)
      << text_of(scripted.scratch / "calls");
}

TEST(LocalSweep, ACrashedRunGoesOnFromItsCheckpointWhenRetriedAndAFailedOneBeginsAnew) {
  ScriptedSweep scripted(
      "touch $folder/checkpoint.cbor\ncase $* in *--resume*) finish ;; *seed=1*) kill -KILL $$ ;; *seed=3*) exit 4 ;; "
      "*) exit 3 ;; esac",
      3);
  EXPECT_EQ(scripted.go()[0].status, Status::failed);
  scripted.settings.launcher.retry = true;
  const auto states = scripted.go();
  EXPECT_EQ(states[0].status, Status::finished);
  EXPECT_EQ(states[1].status, Status::failed);
  EXPECT_EQ(states[1].exit_code, 3);
  EXPECT_EQ(states[2].status, Status::finished) << "the disk was full";
}

TEST(LocalSweep, AnInterruptionAsksAllToSaveAndStartsNoMore) {
  // Runs save when they are asked to end, and would take a minute.
  ScriptedSweep scripted(
      "sleep 60 & sleeper=$!\ntrap 'touch $folder/saved; kill $sleeper; exit 143' TERM\ntouch $folder/begun\nwait", 5);
  const auto begun = [&](std::size_t run) { return fs::exists(scripted.sweep.run_folder(run) / "begun"); };
  const auto states = scripted.go({.interrupted = [&] { return begun(0) && begun(1); }});
  for (const std::size_t run : {0U, 1U}) {
    EXPECT_EQ(states[run].status, Status::interrupted);
    EXPECT_TRUE(fs::exists(scripted.sweep.run_folder(run) / "saved")) << run;
  }
  for (const std::size_t run : {2U, 3U, 4U}) EXPECT_EQ(states[run].status, Status::pending);
}

TEST(LocalSweep, NeverRunsMoreThanItsWorkers) {
  ScriptedSweep scripted("sleep 0.05; finish", 7, 3);
  std::size_t most = 0;
  scripted.go({.waiting = [&most](std::size_t running) { most = std::max(most, running); }});
  EXPECT_EQ(most, 3U);
  EXPECT_EQ(scripted.calls(), 7);
}

TEST(LocalSweep, LeavesARunToTheProcessThatHoldsItsLock) {
  ScriptedSweep scripted("finish", 2);
  fs::create_directories(scripted.sweep.run_folder(0));
  write_attempt(scripted.sweep.run_folder(0), {});
  std::optional<base::FileLock> lock = base::FileLock::take(lock_file(scripted.sweep.run_folder(0)));
  EXPECT_EQ(scripted.go()[0].status, Status::running);
  EXPECT_EQ(scripted.calls(), 1);
  lock.reset();
  EXPECT_EQ(scripted.go()[0].status, Status::finished);
  EXPECT_EQ(scripted.calls(), 2);
}

TEST(SweepFolder, OfAnotherGridOrOfARunIsRefused) {
  ScriptedSweep scripted("finish", 2);
  Grid other = scripted.sweep.grid;
  EXPECT_EQ(sweep_in(scripted.sweep.folder, other).runs.size(), 2U);
  other.axes[0].values.emplace_back("9");
  EXPECT_THROW(sweep_in(scripted.sweep.folder, other), base::InputError);
  std::ofstream(scripted.scratch / "run.json") << "{}";
  EXPECT_THROW(sweep_in(scripted.scratch.path(), other), base::InputError);
  std::ofstream(scripted.sweep.record()) << "{\"grid\": 3}";
  EXPECT_THROW(read_sweep(scripted.sweep.folder), base::InputError);
}

}  // namespace
}  // namespace foamsim::sweep
