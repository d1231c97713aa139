#include <cstdio>
#include <memory>
#include <optional>

#include "Base/console/interrupt_guard.h"
#include "Base/console/progress.h"
#include "Base/io/csv_table.h"
#include "MultiTracker/app/commands.h"
#include "MultiTracker/scenes/scene.h"
#include "MultiTracker/study/robustness.h"

namespace multitracker::app {
namespace {

struct Arguments {
  RobustnessOptions options;
  std::string out;
  bool quiet = false;
};

void print(const std::vector<RobustnessSummary>& summaries) {
  std::printf("%8s %8s %10s %12s %12s %10s\n", "spheres", "step/L", "success", "shared area", "CPU seconds", "peak MB");
  for (const RobustnessSummary& s : summaries)
    std::printf("%8ld %8g %6ld/%-3ld %12.4g %12.2f %10.0f\n", s.spheres, s.step, s.successes, s.runs, s.shared_area,
                s.cpu_seconds, s.peak_megabytes);
}

int study(const Arguments& arguments) {
  check(arguments.options);  // Before the table of an earlier study is replaced.
  std::optional<base::CsvTable> table;
  if (!arguments.out.empty()) table.emplace(arguments.out, robustness_csv_header());
  const base::InterruptGuard guard;
  std::vector<RobustnessRun> runs;
  {
    base::Progress progress("robustness", arguments.quiet);
    long count = 0;
    runs = run_robustness(arguments.options, {[&](const RobustnessRun& run, double fraction) {
                                                if (table) table->add(robustness_csv_row(run));
                                                progress.show(++count, static_cast<double>(run.spheres), fraction);
                                              },
                                              [] { return base::InterruptGuard::interrupted(); }});
  }
  for (const RobustnessRun& run : runs)
    if (!run.success)
      std::printf("failed: %ld spheres, step %g L, seed %ld: %s\n", run.spheres, run.step, run.seed,
                  run.message.c_str());
  print(summarise(runs));
  if (table) std::printf("runs in %s\n", arguments.out.c_str());
  return base::InterruptGuard::interrupted() ? base::InterruptGuard::exit_code() : exit_done;
}

}  // namespace

void add_study_command(base::Command& root, const Program&) {
  using base::Argument;
  base::Command& studies = root.add_command("study", "many runs, and a table of what they came to");
  base::Command& command =
      studies.add_command("robustness", "spheres that grow into a foam: success rate, shared area, time, memory");
  auto a = std::make_shared<Arguments>();
  command.add({.name = "--spheres", .target = &a->options.spheres, .help = "numbers of spheres, separated by commas"});
  command.add({.name = "--steps-of",
               .target = &a->options.steps,
               .help = "lengths of a step, in mean edges, separated by commas"});
  command.add({.name = "--seeds", .target = &a->options.seeds, .help = "runs of each kind"});
  command.add({.name = "--motion", .target = &a->options.total_motion, .help = "total motion, in mean edges"});
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
  command.add({.name = "--audit",
               .target = &a->options.audit_every_step,
               .help = "audit after every step, not only at the end"});
  command.add({.name = "--out", .target = &a->out, .help = "CSV file, a row a run", .offers = Argument::Offers::files});
  command.add({.name = "--quiet", .target = &a->quiet, .help = "show no progress"});
  command.set_action([a] { return study(*a); });
}

}  // namespace multitracker::app
