#include "FoamSim/sweep/slurm.h"

#include <chrono>
#include <sstream>

#include "Base/error.h"
#include "Base/io/atomic_file.h"
#include "Base/io/number_text.h"
#include "Base/io/write_error.h"
#include "FoamSim/sweep/stable_hash.h"

namespace foamsim::sweep {

namespace fs = std::filesystem;

namespace {

constexpr double patience = 60;  // seconds that a command of Slurm may take

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);)
    if (!line.empty()) lines.push_back(line);
  return lines;
}

std::string last_line(const std::string& text) {
  const auto lines = lines_of(text);
  return lines.empty() ? "nothing" : lines.back();
}

base::CommandResult slurm_command(const std::string& program, const std::vector<std::string>& arguments) {
  try {
    return base::run_command(program, arguments, patience);
  } catch (const base::FileError& error) {
    throw base::InputError(std::string(error.what()) + "; --slurm needs Slurm's commands in PATH");
  }
}

// A task as the queue lists it.
struct QueuedTask {
  std::string job;
  std::size_t run;
};

// What the queue has of a submission, by number or, where that is not known, by name.
std::vector<QueuedTask> tasks_in_queue(const Submission& submission) {
  const std::string which = submission.job.empty() ? "--name=" + submission.job_name : "--jobs=" + submission.job;
  const base::CommandResult answer = slurm_command("squeue", {"--noheader", "--array", "--format=%F %K", which});
  // The queue forgets a job some minutes after its end.
  if (answer.exit_code != 0 && answer.output.find("Invalid job id") != std::string::npos) return {};
  if (answer.exit_code != 0)
    throw base::Error("the queue does not say what is in it (squeue: " + last_line(answer.output) +
                      "), and nothing more is submitted; try again when it answers");
  std::vector<QueuedTask> tasks;
  for (const std::string& line : lines_of(answer.output)) {
    std::istringstream words(line);
    std::string job, index;
    words >> job >> index;
    if (const auto run = base::parse_integer(index); run && *run >= 0)
      tasks.push_back({job, static_cast<std::size_t>(*run)});
  }
  return tasks;
}

// The number in what `sbatch --parsable` says: "123" or "123;CLUSTER", perhaps among warnings.
std::string job_number(const std::string& output) {
  for (const std::string& line : lines_of(output)) {
    std::string number = line.substr(0, line.find(';'));
    if (base::parse_integer(number)) return number;
  }
  return {};
}

fs::path write_job_script(const Sweep& sweep, const Launcher& launcher) {
  fs::path path = sweep.folder / "job.sh";
  base::AtomicFile file(path);
  file.stream() << "#!/bin/sh\n# A task of the sweep's array job makes the run of its index.\nexec "
                << shell_quoted(launcher.program.string()) << " sweep --out " << shell_quoted(sweep.folder.string())
                << " --threads " << launcher.threads << (launcher.retry ? " --retry" : "")
                << " --task \"$SLURM_ARRAY_TASK_ID\"\n";
  file.commit();
  return path;
}

std::vector<std::string> sbatch_arguments(const Sweep& sweep, const std::string& job_name, const std::string& indices,
                                          const SlurmSettings& settings) {
  std::vector<std::string> arguments{"--parsable", "--job-name=" + job_name, "--array=" + indices, "--ntasks=1",
                                     "--output=" + (sweep.folder / "slurm" / "%A_%a.txt").string()};
  if (settings.launcher.threads > 0)
    arguments.push_back("--cpus-per-task=" + std::to_string(settings.launcher.threads));
  if (!settings.partition.empty()) arguments.push_back("--partition=" + settings.partition);
  arguments.insert(arguments.end(), settings.more.begin(), settings.more.end());
  arguments.push_back(write_job_script(sweep, settings.launcher).string());
  return arguments;
}

// sbatch says no; where it lost its answer on the way the job may be there all the same.
std::string after_refusal(Sweep& sweep, const std::string& output) {
  const auto tasks = tasks_in_queue(sweep.submissions.back());
  if (!tasks.empty()) return tasks.front().job;
  sweep.submissions.pop_back();
  write_sweep(sweep);
  throw base::InputError("sbatch refused the job: " + last_line(output));
}

}  // namespace

std::string shell_quoted(const std::string& word) {
  constexpr std::string_view plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=.,/:@%";
  if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

std::string array_indices(const std::vector<std::size_t>& runs) {
  std::string text;
  for (std::size_t begin = 0; begin < runs.size();) {
    std::size_t end = begin + 1;
    while (end < runs.size() && runs[end] == runs[end - 1] + 1) ++end;
    text += (text.empty() ? "" : ",") + std::to_string(runs[begin]);
    if (end > begin + 1) text += "-" + std::to_string(runs[end - 1]);
    begin = end;
  }
  return text;
}

void require_slurm(const std::string& partition) {
  for (const char* program : {"sbatch", "squeue"}) slurm_command(program, {"--version"});
  if (partition.empty()) return;
  const base::CommandResult answer = slurm_command("sinfo", {"--noheader", "--format=%R"});
  if (answer.exit_code != 0)
    throw base::InputError("the cluster does not answer (sinfo: " + last_line(answer.output) + ")");
  const std::vector<std::string> known = lines_of(answer.output);
  if (std::ranges::find(known, partition) != known.end()) return;
  std::string names;
  for (const std::string& name : known) names += (names.empty() ? "" : ", ") + name;
  throw base::InputError("there is no partition '" + partition + "' (there are: " + names + ")");
}

std::set<std::size_t> queued_runs(Sweep& sweep) {
  std::set<std::size_t> queued;
  bool changed = false;
  for (auto it = sweep.submissions.begin(); it != sweep.submissions.end();) {
    const std::vector<QueuedTask> tasks = tasks_in_queue(*it);
    for (const QueuedTask& task : tasks)
      if (task.run < sweep.runs.size()) queued.insert(task.run);
    if (!it->job.empty()) {
      ++it;
      continue;
    }
    changed = true;
    if (tasks.empty())
      it = sweep.submissions.erase(it);
    else
      (it++)->job = tasks.front().job;
  }
  if (changed) write_sweep(sweep);
  return queued;
}

void mark_queued(const std::set<std::size_t>& queued, std::vector<RunState>& states) {
  for (const std::size_t run : queued) {
    RunState& state = states.at(run);
    if (state.status == Status::pending) state.status = Status::queued;
    // Its end was not seen: it goes on, though on a file system that does not share locks between machines.
    if (state.status == Status::interrupted) state.status = state.exit_code ? Status::queued : Status::running;
  }
}

std::string submit(Sweep& sweep, const std::vector<std::size_t>& runs, const SlurmSettings& settings) {
  base::make_folder(sweep.folder / "slurm");
  const auto now = std::chrono::system_clock::now().time_since_epoch().count();
  const std::string job_name = "foamsim-" + stable_hash(sweep.folder.string() + "\n" + std::to_string(now));
  const std::string limit = settings.at_a_time ? "%" + std::to_string(*settings.at_a_time) : "";
  const auto arguments = sbatch_arguments(sweep, job_name, array_indices(runs) + limit, settings);
  sweep.submissions.push_back({job_name, {}});
  write_sweep(sweep);
  const base::CommandResult answer = slurm_command("sbatch", arguments);
  std::string job = answer.exit_code == 0 ? job_number(answer.output) : after_refusal(sweep, answer.output);
  if (job.empty())
    throw base::Error("sbatch gave no number of a job, but said: " + last_line(answer.output) +
                      "; call the same again, which looks for the job by its name, " + job_name);
  sweep.submissions.back().job = job;
  write_sweep(sweep);
  return job;
}

}  // namespace foamsim::sweep
