#include "FoamSim/app/study_sweep.h"

#include <algorithm>
#include <cstdio>
#include <fstream>

#include "Base/error.h"
#include "Base/io/atomic_file.h"
#include "Base/io/csv_table.h"
#include "FoamSim/app/common_arguments.h"
#include "FoamSim/app/session.h"
#include "FoamSim/app/study_commands.h"
#include "FoamSim/app/sweep_session.h"
#include "FoamSim/sweep/slurm.h"
#include "FoamSim/sweep/table.h"

namespace foamsim::app {

namespace fs = std::filesystem;
using sweep::RunState;
using sweep::Status;
using sweep::Sweep;

namespace {

sweep::Grid grid_of(const StudyRows& study) {
  sweep::Grid grid;
  grid.study = study.study;
  grid.fixed = study.fixed;
  for (std::size_t axis = 0; axis < study.axes.size(); ++axis) {
    sweep::Axis values{study.axes[axis], {}};
    for (const std::vector<std::string>& row : study.rows)
      if (std::ranges::find(values.values, row[axis]) == values.values.end()) values.values.push_back(row[axis]);
    grid.axes.push_back(std::move(values));
  }
  return grid;
}

Sweep sweep_of(const StudyRows& study, const StudyWays& ways) {
  const fs::path out = ways.out, table = out / (study.study + ".csv");
  if (ways.force) {
    std::error_code error;
    for (const fs::path& old : {out / "sweep.json", out / "runs", out / "table.csv", table}) fs::remove_all(old, error);
  } else if (fs::exists(table) && !fs::exists(out / "sweep.json")) {
    throw base::InputError(ways.out + " holds a study of one row; give another --out, or --force to replace it");
  }
  sweep::Grid grid = grid_of(study);
  std::vector<sweep::PlannedRun> runs;
  for (const std::vector<std::string>& row : study.rows) runs.push_back(sweep::planned_run(grid, row));
  return sweep::sweep_in(out, std::move(grid), std::move(runs));
}

// The lines behind the header of a run's table.
std::vector<std::string> rows_of(const Sweep& sweep, std::size_t run) {
  std::ifstream in(sweep.run_folder(run) / sweep::table_of_run(sweep.grid));
  std::vector<std::string> rows;
  std::string line;
  std::getline(in, line);
  while (std::getline(in, line)) rows.push_back(line);
  return rows;
}

void write_study_table(const StudyRows& study, const Sweep& sweep, const std::vector<RunState>& states) {
  base::AtomicFile file(sweep.folder / (study.study + ".csv"));
  file.stream() << study.header << '\n';
  for (std::size_t run = 0; run < sweep.runs.size(); ++run)
    if (states[run].status == Status::finished)
      for (const std::string& row : rows_of(sweep, run)) file.stream() << row << '\n';
  file.commit();
}

// Without the line's end, where it has one.
StudyRow study_row(const std::string& header, std::string line) {
  if (line.ends_with('\n')) line.pop_back();
  const std::vector<std::string> columns = base::csv_cells_of(header), cells = base::csv_cells_of(line);
  StudyRow row;
  for (std::size_t i = 0; i < columns.size(); ++i) row[columns[i]] = i < cells.size() ? cells[i] : "";
  return row;
}

void print_row(const StudyRows& study, const Sweep& sweep, std::size_t run, const RunState& state) {
  if (state.status != Status::finished) return print_state(sweep, run, state);
  for (const std::string& row : rows_of(sweep, run)) study.print(study_row(study.header, row));
}

int tell_plan(const Sweep& sweep, const Program& program) {
  sweep::write_sweep(sweep);
  const std::string folder = sweep::shell_quoted(sweep.folder);
  std::printf(
      "%zu rows; to make them: %s sweep --out %s, with --list or --slurm; then this command again without "
      "--plan\n",
      sweep.runs.size(), program.name.c_str(), folder.c_str());
  return exit_done;
}

int make_one_row(const StudyRows& study, const StudyWays& ways, const std::function<void(const RowHooks&)>& here) {
  const std::string file = study.study + ".csv";
  require_new_study(ways.out, file, ways.force);
  const ThreadLimit limit = thread_limit(ways.threads);
  base::CsvTable table(fs::path(ways.out) / file, study.header);
  Progress progress(study.study, ways.quiet);
  here({.row =
            [&](const std::string& line) {
              progress.clear();
              table.add(line);
              study.print(study_row(study.header, line));
            },
        .progress = [&](const std::string& label, double fraction) { progress.show(label, fraction); },
        .interrupted = InterruptGuard::interrupted});
  return InterruptGuard::interrupted() ? InterruptGuard::exit_code() : exit_done;
}

}  // namespace

void add_study_ways(base::Command& command, StudyWays& ways, const std::string& what) {
  add_output(command, ways.out, ways.force, what);
  add_quiet(command, ways.quiet);
  add_threads(command, ways.threads);
  command.add({.name = "--workers",
               .target = &ways.workers,
               .help = "rows at a time (default: one, so that none disturbs another's time)"});
  command.add({.name = "--plan",
               .target = &ways.plan,
               .help = "only write down the rows, for 'foamsim sweep' to make them elsewhere"});
}

int make_study(const StudyRows& study, const StudyWays& ways, const Program& program,
               const std::function<void(const RowHooks&)>& here) {
  require_workers(ways.workers);
  require_threads(ways.threads);
  if (study.rows.size() == 1 && !ways.plan) return make_one_row(study, ways, here);
  Sweep sweep = sweep_of(study, ways);
  if (ways.plan) return tell_plan(sweep, program);
  std::vector<RunState> states = states_with_queue(sweep);
  for (std::size_t run = 0; run < states.size(); ++run)
    if (states[run].status == Status::finished) print_row(study, sweep, run, states[run]);
  SweepSettings settings{.launcher = {.program = own_path(program), .threads = ways.threads, .retry = true},
                         .workers = ways.workers.value_or(1),
                         .label = study.study,
                         .quiet = ways.quiet,
                         .ended = [&](std::size_t run) { print_row(study, sweep, run, states[run]); }};
  make_runs(sweep, settings, states);
  sweep::write_table(sweep, states);
  write_study_table(study, sweep, states);
  if (InterruptGuard::interrupted()) {
    std::printf("%s; the same command goes on\n", counts_text(states).c_str());
    return InterruptGuard::exit_code();
  }
  return exit_code_for(states);
}

}  // namespace foamsim::app
