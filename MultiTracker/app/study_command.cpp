#include <algorithm>
#include <cstdio>
#include <memory>
#include <optional>
#include <thread>

#include "Base/console/interrupt_guard.h"
#include "Base/console/progress.h"
#include "Base/console/thread_limit.h"
#include "Base/error.h"
#include "MultiTracker/app/commands.h"
#include "MultiTracker/scenes/scene.h"
#include "MultiTracker/study/robustness.h"

namespace multitracker::app {
namespace {

struct StudyArguments {
  RobustnessOptions options;
  std::string out;
  std::optional<double> motion;
  long workers = 1, threads = 0;
  bool quiet = false;
};

void print(const std::vector<RobustnessSummary>& summaries) {
  std::printf("%8s %8s %10s %12s %12s %10s\n", "spheres", "step/L", "success", "shared area", "CPU seconds", "peak MB");
  for (const RobustnessSummary& s : summaries)
    std::printf("%8ld %8g %6ld/%-3ld %12.4g %12.2f %10.0f\n", s.spheres, s.step, s.successes, s.runs, s.shared_area,
                s.cpu_seconds, s.peak_megabytes);
}

RobustnessOptions options_of(const StudyArguments& arguments) {
  constexpr double most_motion_until_closed = 20;  // mean edges; some may never close
  RobustnessOptions options = arguments.options;
  if (options.until_closed) options.total_motion = most_motion_until_closed;
  if (arguments.motion) options.total_motion = *arguments.motion;
  constexpr long most_workers = 4096;
  if (arguments.workers < 1 || arguments.workers > most_workers)
    throw base::InputError("--workers has to be a whole number from 1 to " + std::to_string(most_workers));
  if (arguments.threads < 0) throw base::InputError("--threads has to be a whole number >= 0");
  options.workers = static_cast<int>(arguments.workers);
  options.folder = arguments.out;
  check(options);
  return options;
}

// Of each run; by default the workers share out the cores.
int threads_of(const StudyArguments& arguments) {
  if (arguments.threads > 0 || arguments.workers == 1) return static_cast<int>(arguments.threads);
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency() / arguments.workers));
}

int study(const StudyArguments& arguments) {
  const RobustnessOptions options = options_of(arguments);
  const base::ThreadLimit limit(threads_of(arguments));
  const base::InterruptGuard guard;
  std::vector<RobustnessRun> runs;
  {
    base::Progress progress("robustness", arguments.quiet);
    long count = 0;
    runs = run_robustness(options, {[&](const RobustnessRun& run, double fraction) {
                                      progress.show(++count, static_cast<double>(run.key.spheres), fraction);
                                    },
                                    [] { return base::InterruptGuard::interrupted(); }});
  }
  for (const RobustnessRun& run : runs)
    if (!run.success())
      std::printf("%s: %ld spheres, step %g L, seed %ld: %s\n", name(run.verdict), run.key.spheres, run.key.step,
                  run.key.seed, run.message.c_str());
  print(summarise(runs));
  if (!arguments.out.empty()) {
    const bool stopped = base::InterruptGuard::interrupted();
    std::printf("table and runs in %s%s\n", arguments.out.c_str(), stopped ? "; the same command goes on" : "");
  }
  return base::InterruptGuard::interrupted() ? base::InterruptGuard::exit_code() : exit_done;
}

}  // namespace

void add_study_command(base::Command& root, const Program&) {
  using base::Argument;
  base::Command& studies = root.add_command("study", "many runs, and a table of what they came to");
  base::Command& command =
      studies.add_command("robustness", "spheres that grow into a foam: success rate, shared area, time, memory");
  auto a = std::make_shared<StudyArguments>();
  command.add({.name = "--spheres", .target = &a->options.spheres, .help = "numbers of spheres, separated by commas"});
  command.add({.name = "--steps-of",
               .target = &a->options.steps,
               .help = "lengths of a step, in mean edges, separated by commas"});
  command.add({.name = "--seeds", .target = &a->options.seeds, .help = "runs of each kind"});
  command.add({.name = "--motion",
               .target = &a->motion,
               .help = "total motion, in mean edges (default: 5.5; at most 20 with --until-closed)"});
  command.add(
      {.name = "--until-closed",
       .target = &a->options.until_closed,
       .help = "end a run as soon as no tunnel or pocket of air is left in the foam; one that ends before is open"});
  command.add(
      {.name = "--layout", .target = &a->options.layout, .help = "grid or random", .names = {"grid", "random"}});
  command.add({.name = "--set",
               .target = &a->options.assignments,
               .help = "key=value for scene normal-flow; repeat for more",
               .list = Argument::List::words,
               .assigns = options_of(scene_by_name("normal-flow")).specs()});
  command.add({.name = "--time-limit",
               .target = &a->options.time_limit,
               .help = "of a run, in seconds; longer ones count as failures"});
  command.add({.name = "--workers", .target = &a->workers, .help = "runs at a time, each in a process of its own"});
  command.add({.name = "--threads",
               .target = &a->threads,
               .help = "of each run; 0: all cores, or the workers' shares of them; results do not depend on it"});
  command.add({.name = "--audit",
               .target = &a->options.audit_every_step,
               .help = "audit after every step, not only at the end"});
  command.add(
      {.name = "--out",
       .target = &a->out,
       .help = "folder for table.csv, a row a run, and checkpoints; the same command goes on where it was stopped",
       .offers = Argument::Offers::folders});
  command.add({.name = "--quiet", .target = &a->quiet, .help = "show no progress"});
  command.set_action([a] { return study(*a); });
}

}  // namespace multitracker::app
