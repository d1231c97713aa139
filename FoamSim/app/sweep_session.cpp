#include "FoamSim/app/sweep_session.h"

#include <algorithm>
#include <cstdio>
#include <thread>

#include "Base/error.h"
#include "Base/timing/stopwatch.h"
#include "FoamSim/app/session.h"
#include "FoamSim/sweep/slurm.h"
#include "FoamSim/sweep/table.h"

namespace foamsim::app {

namespace fs = std::filesystem;
using sweep::RunState;
using sweep::Status;
using sweep::Sweep;

namespace {

constexpr long most_workers = 10000;

// Shows how far a sweep is and keeps its table up to date.
class SweepDisplay {
 public:
  SweepDisplay(const Sweep& sweep, const std::vector<RunState>& states, const SweepSettings& settings)
      : sweep_(sweep), states_(states), settings_(settings), progress_(settings.label, settings.quiet) {}

  void ended(std::size_t run) {
    constexpr double table_interval = 5;  // seconds
    progress_.clear();
    if (settings_.ended) settings_.ended(run);
    std::fflush(stdout);
    if (since_table_.seconds() < table_interval) return;
    sweep::write_table(sweep_, states_);
    since_table_.restart();
  }

  void waiting() {
    constexpr double interval = 0.1;  // seconds
    if (since_shown_.seconds() < interval) return;
    since_shown_.restart();
    const std::size_t done = count_of(states_, Status::finished) + count_of(states_, Status::failed);
    progress_.show(counts_text(states_), static_cast<double>(done) / static_cast<double>(states_.size()));
  }

 private:
  const Sweep& sweep_;
  const std::vector<RunState>& states_;
  const SweepSettings& settings_;
  Progress progress_;
  base::Stopwatch since_table_, since_shown_;
};

}  // namespace

fs::path own_path(const Program& program) {
  std::error_code error;
  const fs::path path = fs::read_symlink("/proc/self/exe", error);
  return error ? fs::path(program.name) : path;
}

void require_workers(std::optional<long> workers) {
  if (workers && (*workers < 1 || *workers > most_workers))
    throw base::InputError("--workers has to be a whole number from 1 to " + std::to_string(most_workers));
}

std::size_t count_of(const std::vector<RunState>& states, Status status) {
  return static_cast<std::size_t>(std::ranges::count(states, status, &RunState::status));
}

std::string counts_text(const std::vector<RunState>& states) {
  std::string text;
  for (const Status status :
       {Status::finished, Status::failed, Status::interrupted, Status::running, Status::queued, Status::pending})
    if (const std::size_t count = count_of(states, status); count > 0)
      text += (text.empty() ? "" : ", ") + std::to_string(count) + " " + sweep::name(status);
  return text;
}

void print_state(const Sweep& sweep, std::size_t run, const RunState& state) {
  std::printf("%s: %s%s%s\n", sweep.runs[run].name.c_str(), sweep::name(state.status),
              state.message.empty() ? "" : ": ", state.message.c_str());
}

int exit_code_for(const std::vector<RunState>& states) {
  const std::size_t failed = count_of(states, Status::failed), finished = count_of(states, Status::finished);
  if (failed + finished < states.size()) return exit_unfinished;
  return failed > 0 ? exit_cannot_go_on : exit_done;
}

std::vector<std::size_t> runs_to_make(const std::vector<RunState>& states, bool retry) {
  std::vector<std::size_t> runs;
  for (std::size_t run = 0; run < states.size(); ++run)
    if (sweep::wants_start(states[run], retry)) runs.push_back(run);
  return runs;
}

std::vector<RunState> states_with_queue(Sweep& sweep) {
  std::vector<RunState> states = sweep::states_of(sweep);
  if (!sweep.submissions.empty()) sweep::mark_queued(sweep::queued_runs(sweep), states);
  return states;
}

void make_runs(Sweep& sweep, const SweepSettings& settings, std::vector<RunState>& states) {
  if (count_of(states, Status::queued) > 0)
    throw base::InputError("runs of this sweep are queued as job " + sweep.submissions.back().job +
                           "; wait for them (--collect), or cancel the job first");
  sweep::write_sweep(sweep);
  const int cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  const int fitting = settings.launcher.threads == 0 ? 1 : std::max(1, cores / settings.launcher.threads);
  SweepDisplay display(sweep, states, settings);
  sweep::run_locally(sweep, runs_to_make(states, settings.launcher.retry),
                     {.launcher = settings.launcher, .workers = static_cast<int>(settings.workers.value_or(fitting))},
                     {.ended = [&](std::size_t run) { display.ended(run); },
                      .waiting = [&](std::size_t) { display.waiting(); },
                      .interrupted = InterruptGuard::interrupted},
                     states);
}

}  // namespace foamsim::app
