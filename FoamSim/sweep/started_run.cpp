#include "FoamSim/sweep/started_run.h"

#include <csignal>
#include <fstream>

#include "Base/exit_code.h"
#include "Base/io/write_error.h"

namespace foamsim::sweep {

namespace fs = std::filesystem;

namespace {

fs::path log_file(const fs::path& folder) {
  return folder / "log.txt";
}

// Arguments that go on where the last attempt was, or begin anew.
std::vector<std::string> arguments_for(const Sweep& sweep, std::size_t run, const Launcher& launcher,
                                       const RunState& state, int last_signal) {
  const fs::path folder = sweep.run_folder(run), checkpoint = folder / "checkpoint.cbor";
  const bool goes_on = state.status == Status::interrupted || last_signal != 0 ||
                       state.exit_code == static_cast<long>(base::exit_disk_full);
  std::vector<std::string> arguments;
  if (goes_on && fs::exists(checkpoint)) {
    arguments = {"run", "--resume", checkpoint.string()};
    const std::vector<std::string> stop = stop_arguments(sweep.grid);
    arguments.insert(arguments.end(), stop.begin(), stop.end());
  } else {
    // The folder is the sweep's own: what a failed attempt left there may be replaced.
    arguments = run_arguments(sweep.grid, sweep.runs[run]);
    arguments.insert(arguments.end(), {"--out", folder.string(), "--force"});
  }
  arguments.insert(arguments.end(), {"--threads", std::to_string(launcher.threads), "--quiet"});
  return arguments;
}

}  // namespace

bool wants_start(const RunState& state, bool retry) {
  return state.status == Status::pending || state.status == Status::interrupted ||
         (retry && state.status == Status::failed);
}

std::optional<StartedRun> StartedRun::start(const Sweep& sweep, std::size_t run, const Launcher& launcher) {
  const fs::path folder = sweep.run_folder(run);
  base::make_folder(folder);
  std::optional<base::FileLock> lock = base::FileLock::take(lock_file(folder));
  if (!lock) return std::nullopt;
  const RunState state = recorded_state(folder);
  if (!wants_start(state, launcher.retry)) return std::nullopt;
  const int last_signal = read_attempt(folder).value_or(Attempt{}).signal;
  write_attempt(folder, {});
  const fs::path log = log_file(folder);
  const std::uintmax_t log_begin = fs::exists(log) ? fs::file_size(log) : 0;
  base::ChildProcess process({.program = launcher.program,
                              .arguments = arguments_for(sweep, run, launcher, state, last_signal),
                              .output = log,
                              .own_group = launcher.own_group,
                              .keep_open = lock->descriptor()});
  return StartedRun(folder, launcher.program.filename().string(), std::move(*lock), std::move(process), log_begin);
}

StartedRun::StartedRun(fs::path folder, std::string program, base::FileLock lock, base::ChildProcess process,
                       std::uintmax_t log_begin)
    : folder_(std::move(folder)),
      program_(std::move(program)),
      lock_(std::move(lock)),
      process_(std::move(process)),
      log_begin_(log_begin) {}

std::optional<RunState> StartedRun::end() {
  const std::optional<base::ProcessEnd> end = process_.end();
  if (!end) return std::nullopt;
  Attempt attempt{end->exit_code, end->signal, last_words()};
  if (end->signal != 0)
    attempt.message = base::signal_text(end->signal) + (attempt.message.empty() ? "" : ": " + attempt.message);
  write_attempt(folder_, attempt);
  const RunState state = recorded_state(folder_);
  lock_.reset();
  return state;
}

void StartedRun::stop() const {
  process_.signal(SIGTERM);
}

std::string StartedRun::last_words() const {
  std::ifstream log(log_file(folder_), std::ios::binary);
  log.seekg(static_cast<std::streamoff>(log_begin_));
  std::string last;
  for (std::string line; std::getline(log, line);)
    if (!line.empty()) last = std::move(line);
  const std::string prefix = program_ + ": ";
  return last.starts_with(prefix) ? last.substr(prefix.size()) : last;
}

}  // namespace foamsim::sweep
