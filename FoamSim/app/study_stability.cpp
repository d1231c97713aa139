#include <cstdio>
#include <memory>

#include "Base/error.h"
#include "Base/io/csv_table.h"
#include "FoamSim/app/session.h"
#include "FoamSim/app/study_commands.h"
#include "FoamSim/studies/stability/stability_csv.h"

namespace foamsim::app {

namespace {

// --quick makes a twentieth of the steps.
constexpr double quick_scale = 0.05;

struct Arguments {
  StabilityOptions options;
  std::string out = "out/stability", remeshing = "both";
  bool list = false, quick = false, quiet = false, force = false;
  int threads = 0;
};

void print_header() {
  std::printf("%-17s %-14s %-5s %-7s %9s %9s %9s %8s  %s\n", "case", "strategy", "mesh", "verdict", "energy", "volume",
              "impulse", "seconds", "figure; reason");
  std::printf("%-17s %-14s %-5s %-7s %9s %9s %9s\n", "", "", "", "", "rise", "drift", "drift");
}

void print(const StabilityRow& row) {
  const Verdict& v = row.verdict;
  std::printf("%-17s %-14s %-5s %-7s %8.3f%% %8.3f%% %8.3f%% %8.1f  ", row.name.c_str(), row.area.c_str(),
              row.remeshing ? "moves" : "fixed", v.passed ? "pass" : "FAIL", 100 * row.physics.energy_rise,
              100 * row.physics.volume_drift, 100 * row.physics.impulse_drift, row.seconds);
  if (v.figure)
    std::printf("%s %.4g; ", v.figure_name.c_str(), *v.figure);
  else if (!v.figure_name.empty())
    std::printf("%s: none; ", v.figure_name.c_str());
  std::printf("%s\n", v.reason.c_str());
  std::fflush(stdout);
}

int list_cases() {
  const PhysicsLimits limits;
  std::printf(
      "limits of physics, where nothing is put in: energy rises above its least so far by at most %g%% of the "
      "start's,\n"
      "volumes drift by at most %g%%, the impulse by %g%% of the largest sum of its parts' sizes; audits are "
      "clean.\n\n",
      100 * limits.energy_rise, 100 * limits.volume_drift, 100 * limits.impulse_drift);
  for (const StabilityCase& c : stability_cases())
    std::printf("%-17s %s\n%-17s holds: %s\n", std::string(c.name).c_str(), std::string(c.summary).c_str(), "",
                std::string(c.criterion).c_str());
  return exit_done;
}

std::vector<bool> remeshing_from(const std::string& word) {
  if (word == "both") return {true, false};
  if (word == "on") return {true};
  if (word == "off") return {false};
  throw base::InputError("--remeshing " + word + " is not known; it has to be on, off or both");
}

int study_stability_command(Arguments& arguments) {
  if (arguments.list) return list_cases();
  StabilityOptions& options = arguments.options;
  options.remeshing = remeshing_from(arguments.remeshing);
  if (arguments.quick) options.steps_scale *= quick_scale;
  validate(options);
  const std::filesystem::path out = arguments.out;
  require_new_study(out, "stability.csv", arguments.force);
  const ThreadLimit limit(arguments.threads);
  const InterruptGuard guard;
  base::CsvTable table(out / "stability.csv", stability_csv_header());
  print_header();
  std::size_t failed = 0, all = 0;
  {
    Progress progress("stability", arguments.quiet);
    study_stability(options,
                    {.row =
                         [&](const StabilityRow& row) {
                           progress.clear();
                           table.add(stability_csv_row(row));
                           print(row);
                           ++all;
                           failed += row.verdict.passed ? 0 : 1;
                         },
                     .progress = [&](const std::string& label, double fraction) { progress.show(label, fraction); },
                     .interrupted = InterruptGuard::interrupted});
  }
  std::printf("%zu of %zu passed; table in %s\n", all - failed, all, (out / "stability.csv").c_str());
  return InterruptGuard::interrupted() ? exit_interrupted : exit_done;
}

}  // namespace

void add_study_stability(CLI::App& study, Program& program) {
  CLI::App* command = study.add_subcommand(
      "stability", "named hard cases with each strategy, remeshing on and off: a verdict for each, failures included");
  auto arguments = std::make_shared<Arguments>();
  StabilityOptions& options = arguments->options;
  command->add_flag("--list", arguments->list, "name the cases and what has to hold, and run nothing");
  command->add_option("--cases", options.cases, "cases, separated by commas (default: all)")->delimiter(',');
  command->add_option("--areas", options.areas, "strategies, separated by commas")->delimiter(',');
  command->add_option("--remeshing", arguments->remeshing, "on, off or both")->capture_default_str();
  command->add_flag("--quick", arguments->quick, "a twentieth of the steps");
  command->add_option("--steps-scale", options.steps_scale, "multiplies the number of steps")->capture_default_str();
  command->add_option("--case-seconds", options.most_seconds, "wall time after which a motion is stopped and fails")
      ->capture_default_str();
  command->add_option("--out", arguments->out, "folder for stability.csv")->capture_default_str();
  command->add_flag("--force", arguments->force, "replace a study that the folder holds");
  command->add_flag("--quiet", arguments->quiet, "no progress");
  command->add_option("--threads", arguments->threads, "number of threads (default: all cores)");
  command->callback([arguments, &program] { program.exit_code = study_stability_command(*arguments); });
}

}  // namespace foamsim::app
