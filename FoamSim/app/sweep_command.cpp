#include <cstdio>
#include <memory>

#include "Base/console/terminal.h"
#include "Base/error.h"
#include "Base/io/file_lock.h"
#include "Base/io/write_error.h"
#include "FoamSim/app/commands.h"
#include "FoamSim/app/common_arguments.h"
#include "FoamSim/app/session.h"
#include "FoamSim/app/sweep_session.h"
#include "FoamSim/sweep/slurm.h"
#include "FoamSim/sweep/table.h"

namespace foamsim::app {

namespace fs = std::filesystem;
using sweep::RunState;
using sweep::Status;
using sweep::Sweep;

namespace {

// More have to be confirmed.
constexpr std::size_t most_without_asking = 1000;

struct SweepArguments {
  std::string grid, out, run, partition;
  std::vector<std::string> sbatch;
  std::optional<long> workers, task;
  int threads = 1;
  bool list = false, slurm = false, collect = false, retry = false, yes = false, quiet = false;
};

sweep::Launcher launcher_of(const SweepArguments& arguments, const Program& program) {
  return {.program = own_path(program), .threads = arguments.threads, .retry = arguments.retry};
}

// Reads the grid, or what the folder holds where none is given; checks all of it and writes nothing.
Sweep load_sweep(const SweepArguments& arguments, const Program& program) {
  if (arguments.grid.empty()) {
    if (arguments.out.empty()) throw base::InputError("sweep needs a grid file, or --out with the folder of a sweep");
    return sweep::read_sweep(arguments.out);
  }
  sweep::Grid grid = sweep::read_grid(arguments.grid, program.catalogue);
  const std::size_t count = sweep::count_runs(grid);
  if (count > most_without_asking && !arguments.yes)
    throw base::InputError(arguments.grid + ": these are " + (count == sweep::most_runs_counted ? "at least " : "") +
                           std::to_string(count) + " runs, more than " + std::to_string(most_without_asking) +
                           "; give --yes if that is meant");
  const fs::path out =
      arguments.out.empty() ? fs::path("out") / fs::path(arguments.grid).stem() : fs::path(arguments.out);
  Sweep loaded = sweep::sweep_in(out, std::move(grid));
  try {
    sweep::require_valid(loaded.grid, loaded.runs, program.catalogue);
  } catch (const base::InputError& error) {
    throw base::InputError(arguments.grid + ": " + error.what());
  }
  return loaded;
}

void print_summary_of(const Sweep& sweep, const std::vector<RunState>& states) {
  for (std::size_t run = 0; run < states.size(); ++run)
    if (states[run].status == Status::failed)
      std::printf("failed: %s: %s\n", sweep.runs[run].name.c_str(), states[run].message.c_str());
  std::printf("%zu runs: %s; table in %s\n", states.size(), counts_text(states).c_str(), sweep.table().c_str());
}

// What the folders say is worth a table also where there is no queue to ask any more.
std::vector<RunState> states_to_collect(const Program& program, Sweep& sweep) {
  try {
    return states_with_queue(sweep);
  } catch (const base::Error& error) {
    base::print_warning(program.name, std::string("without what is in the queue: ") + error.what());
    return sweep::states_of(sweep);
  }
}

int list_runs(const SweepArguments& arguments, const Program& program, const Sweep& sweep,
              const std::vector<RunState>& states) {
  sweep::write_sweep(sweep);
  for (const std::size_t run : runs_to_make(states, arguments.retry))
    std::printf("%s sweep --out %s --threads %d%s --quiet --run %s\n", sweep::shell_quoted(own_path(program)).c_str(),
                sweep::shell_quoted(sweep.folder).c_str(), arguments.threads, arguments.retry ? " --retry" : "",
                sweep.runs[run].name.c_str());
  return exit_done;
}

int collect(const SweepArguments& arguments, const Sweep& sweep, const std::vector<RunState>& states) {
  sweep::write_table(sweep, states);
  if (!arguments.quiet) print_summary_of(sweep, states);
  return exit_code_for(states);
}

int submit_runs(const SweepArguments& arguments, const Program& program, Sweep& sweep) {
  base::make_folder(sweep.folder);
  const auto lock = base::FileLock::take(sweep.folder / "submit.lock");
  if (!lock) throw base::InputError("another process submits runs of " + sweep.folder.string() + " now");
  // What another process may have submitted until the lock was free.
  if (fs::exists(sweep.record())) sweep = sweep::read_sweep(sweep.folder);
  const std::vector<RunState> states = states_with_queue(sweep);
  const std::vector<std::size_t> todo = runs_to_make(states, arguments.retry);
  if (todo.empty()) {
    if (!arguments.quiet) std::printf("nothing to submit\n");
    return collect(arguments, sweep, states);
  }
  sweep::SlurmSettings settings{launcher_of(arguments, program), {}, arguments.partition, arguments.sbatch};
  if (arguments.workers) settings.at_a_time = static_cast<int>(*arguments.workers);
  const std::string job = sweep::submit(sweep, todo, settings);
  if (!arguments.quiet)
    std::printf("submitted %zu runs as job %s; to gather the table: %s sweep --collect --out %s\n", todo.size(),
                job.c_str(), program.name.c_str(), sweep::shell_quoted(sweep.folder).c_str());
  return exit_done;
}

int run_here(const SweepArguments& arguments, const Program& program, Sweep& sweep, std::vector<RunState>& states) {
  const InterruptGuard guard;
  SweepSettings settings{.launcher = launcher_of(arguments, program),
                         .workers = arguments.workers,
                         .label = "sweep",
                         .quiet = arguments.quiet};
  if (!arguments.quiet) settings.ended = [&](std::size_t run) { print_state(sweep, run, states[run]); };
  make_runs(sweep, settings, states);
  const int code = collect(arguments, sweep, states);
  if (!InterruptGuard::interrupted()) return code;
  if (!arguments.quiet)
    std::printf("to go on: %s sweep --out %s\n", program.name.c_str(), sweep::shell_quoted(sweep.folder).c_str());
  return InterruptGuard::exit_code();
}

std::size_t index_of_run(const SweepArguments& arguments, const Sweep& sweep) {
  if (arguments.task) {
    if (*arguments.task < 0 || static_cast<std::size_t>(*arguments.task) >= sweep.runs.size())
      throw base::InputError("--task " + std::to_string(*arguments.task) + ": the sweep has the tasks 0 to " +
                             std::to_string(sweep.runs.size() - 1));
    return static_cast<std::size_t>(*arguments.task);
  }
  const auto found = std::ranges::find(sweep.runs, arguments.run, &sweep::PlannedRun::name);
  if (found == sweep.runs.end())
    throw base::InputError("--run: the sweep in " + sweep.folder.string() + " has no run '" + arguments.run + "'");
  return static_cast<std::size_t>(found - sweep.runs.begin());
}

// One run of a sweep that is recorded already: what --list prints and what a task of an array job does.
int make_one_run(const SweepArguments& arguments, const Program& program) {
  if (arguments.out.empty()) throw base::InputError("--run and --task need --out with the folder of a sweep");
  const Sweep sweep = sweep::read_sweep(arguments.out);
  const std::size_t run = index_of_run(arguments, sweep);
  sweep::LocalSettings settings{.launcher = launcher_of(arguments, program)};
  // A queue sends its signals to every process of a task.
  settings.pass_on_signals = settings.launcher.own_group = !arguments.task;
  std::vector<RunState> states(sweep.runs.size());
  states[run] = sweep::look_at(sweep.run_folder(run));
  const InterruptGuard guard;
  if (sweep::wants_start(states[run], arguments.retry))
    sweep::run_locally(sweep, {run}, settings, {.interrupted = InterruptGuard::interrupted}, states);
  const RunState& state = states[run];
  if (state.status == Status::failed) base::print_error(program.name, arguments.run + ": " + state.message);
  if (!arguments.quiet) std::printf("%s: %s\n", sweep.runs[run].name.c_str(), sweep::name(state.status));
  if (state.status == Status::failed || state.status == Status::interrupted)
    return static_cast<int>(state.exit_code.value_or(exit_cannot_go_on));
  return state.status == Status::finished ? exit_done : exit_unfinished;
}

int run_sweep(const SweepArguments& arguments, const Program& program) {
  require_workers(arguments.workers);
  require_threads(arguments.threads);
  if (!arguments.slurm && (!arguments.partition.empty() || !arguments.sbatch.empty()))
    throw base::InputError("--partition and --sbatch are for --slurm");
  if (!arguments.run.empty() || arguments.task) return make_one_run(arguments, program);
  Sweep sweep = load_sweep(arguments, program);
  if (arguments.slurm) {
    sweep::require_slurm(arguments.partition);
    return submit_runs(arguments, program, sweep);
  }
  if (arguments.collect) return collect(arguments, sweep, states_to_collect(program, sweep));
  std::vector<RunState> states = states_with_queue(sweep);
  if (arguments.list) return list_runs(arguments, program, sweep, states);
  return run_here(arguments, program, sweep, states);
}

// What is done with the runs in the place of making them here; one at most.
void add_ways(base::Command& command, SweepArguments& given) {
  const std::vector<std::string> ways{"--list", "--slurm", "--collect", "--run", "--task"};
  const auto others = [&ways](const std::string& own) {
    std::vector<std::string> names = ways;
    std::erase(names, own);
    return names;
  };
  command.add({.name = "--list",
               .target = &given.list,
               .help = "print a command for each run that is to be made, for GNU parallel or xargs, and run nothing",
               .excludes = others("--list")});
  command.add({.name = "--slurm",
               .target = &given.slurm,
               .help = "submit the runs as one array job of Slurm",
               .excludes = others("--slurm")});
  command.add({.name = "--partition", .target = &given.partition, .help = "of the job (with --slurm)"});
  command.add({.name = "--sbatch",
               .target = &given.sbatch,
               .help = "one more word for sbatch, --sbatch=--mem=2G; may be given several times",
               .list = base::Argument::List::words});
  command.add({.name = "--collect",
               .target = &given.collect,
               .help = "gather the table of what is there, and run nothing",
               .excludes = others("--collect")});
  command.add({.name = "--run", .target = &given.run, .help = "make this one run", .excludes = others("--run")});
  command.add({.name = "--task",
               .target = &given.task,
               .help = "make the run of this index, as a task of an array job",
               .excludes = others("--task")});
}

}  // namespace

void add_sweep_command(base::Command& root, const Program& program) {
  base::Command& command = root.add_command("sweep", "run a scene with every combination of some options' values");
  auto given = std::make_shared<SweepArguments>();
  using Offers = base::Argument::Offers;
  command.add({.name = "grid",
               .target = &given->grid,
               .help = "grid file (.toml): a scene, options, and lists of values; left out: that of the folder",
               .offers = Offers::files});
  command.add({.name = "--out",
               .target = &given->out,
               .help = "folder for runs and table (default: out/GRID); a sweep that it holds goes on",
               .offers = Offers::folders});
  command.add({.name = "--workers",
               .target = &given->workers,
               .help = "runs at a time (default: what the cores have room for; with --slurm: any number)"});
  command.add({.name = "--threads", .target = &given->threads, .help = "threads of each run; 0: all cores"});
  command.add({.name = "--retry", .target = &given->retry, .help = "make runs that failed again"});
  command.add({.name = "--yes", .target = &given->yes, .help = "go on with more than 1000 runs"});
  add_ways(command, *given);
  add_quiet(command, given->quiet);
  command.set_action([given, &program] { return run_sweep(*given, program); });
}

}  // namespace foamsim::app
