#include <cstdio>
#include <memory>
#include <optional>

#include "Base/console/interrupt_guard.h"
#include "Base/console/progress.h"
#include "Base/io/csv_table.h"
#include "MultiTracker/app/commands.h"
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
  return base::InterruptGuard::interrupted() ? exit_interrupted : exit_done;
}

}  // namespace

void add_study_command(CLI::App& app, Program& program) {
  CLI::App* studies = app.add_subcommand("study", "many runs, and a table of what they came to");
  studies->require_subcommand(1);
  CLI::App* command =
      studies->add_subcommand("robustness", "spheres that grow into a foam: success rate, shared area, time, memory");
  auto a = std::make_shared<Arguments>();
  command->add_option("--spheres", a->options.spheres, "numbers of spheres")->delimiter(',')->capture_default_str();
  command->add_option("--steps-of", a->options.steps, "lengths of a step, in mean edges")
      ->delimiter(',')
      ->capture_default_str();
  command->add_option("--seeds", a->options.seeds, "runs of each kind")->capture_default_str();
  command->add_option("--motion", a->options.total_motion, "total motion, in mean edges")->capture_default_str();
  command->add_option("--layout", a->options.layout, "grid or random")->capture_default_str();
  command->add_option("--set", a->options.assignments, "key=value for scene normal-flow; repeat for more")
      ->type_size(1)
      ->allow_extra_args(false);
  command->add_option("--time-limit", a->options.time_limit, "of a run, in seconds; longer ones count as failures")
      ->capture_default_str();
  command->add_flag("--audit", a->options.audit_every_step, "audit after every step, not only at the end");
  command->add_option("--out", a->out, "CSV file, a row a run");
  command->add_flag("--quiet", a->quiet, "show no progress");
  command->callback([a, &program] { program.exit_code = study(*a); });
}

}  // namespace multitracker::app
