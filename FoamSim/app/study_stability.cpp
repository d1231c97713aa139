#include <cstdio>
#include <memory>

#include "Base/error.h"
#include "Base/io/csv_table.h"
#include "FoamSim/app/common_arguments.h"
#include "FoamSim/app/session.h"
#include "FoamSim/app/study_commands.h"
#include "FoamSim/scenes/methods.h"
#include "FoamSim/studies/stability/stability_csv.h"

namespace foamsim::app {

namespace {

// --quick makes a twentieth of the steps.
constexpr double quick_scale = 0.05;

struct StabilityArguments {
  StabilityOptions options;
  std::string out = "out/stability", remeshing = "both";
  bool list = false, quick = false, quiet = false, force = false;
  int threads = 0;
};

void print_stability_header() {
  std::printf("%-17s %-14s %-5s %-7s %9s %9s %9s %8s  %s\n", "case", "strategy", "mesh", "verdict", "energy", "volume",
              "impulse", "seconds", "figure; reason");
  std::printf("%-17s %-14s %-5s %-7s %9s %9s %9s\n", "", "", "", "", "rise", "drift", "drift");
}

void print_verdict(const StabilityRow& row) {
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
  const PhysicsLimits limits, conservative = physics_limits(conservative_method);
  std::printf(
      "limits of physics, where nothing is put in: energy rises above its least so far by at most %g%% of the "
      "start's,\n"
      "volumes drift by at most %g%%, the impulse by %g%% of the largest sum of its parts' sizes; audits are "
      "clean. The conservative scheme is held to %g%%, %g%% and %g%%.\n\n",
      100 * limits.energy_rise, 100 * limits.volume_drift, 100 * limits.impulse_drift, 100 * conservative.energy_rise,
      100 * conservative.volume_drift, 100 * conservative.impulse_drift);
  for (const StabilityCase& c : stability_cases())
    std::printf("%-17s %s\n%-17s holds: %s%s\n", std::string(c.name).c_str(), std::string(c.summary).c_str(), "",
                std::string(c.criterion).c_str(), c.when_named ? " (takes long: only when named)" : "");
  return exit_done;
}

std::vector<bool> remeshing_from(const std::string& word) {
  if (word == "both") return {true, false};
  return {word == "on"};
}

std::vector<std::string> case_names() {
  std::vector<std::string> names;
  for (const StabilityCase& c : stability_cases()) names.emplace_back(c.name);
  return names;
}

int study_stability_command(StabilityArguments& arguments) {
  if (arguments.list) return list_cases();
  StabilityOptions& options = arguments.options;
  options.remeshing = remeshing_from(arguments.remeshing);
  if (arguments.quick) options.steps_scale *= quick_scale;
  validate(options);
  const std::filesystem::path out = arguments.out;
  require_new_study(out, "stability.csv", arguments.force);
  const ThreadLimit limit = thread_limit(arguments.threads);
  const InterruptGuard guard;
  base::CsvTable table(out / "stability.csv", stability_csv_header());
  print_stability_header();
  std::size_t failed = 0, all = 0;
  {
    Progress progress("stability", arguments.quiet);
    study_stability(options,
                    {.row =
                         [&](const StabilityRow& row) {
                           progress.clear();
                           table.add(stability_csv_row(row));
                           print_verdict(row);
                           ++all;
                           failed += row.verdict.passed ? 0 : 1;
                         },
                     .progress = [&](const std::string& label, double fraction) { progress.show(label, fraction); },
                     .interrupted = InterruptGuard::interrupted});
  }
  std::printf("%zu of %zu passed; table in %s\n", all - failed, all, (out / "stability.csv").c_str());
  return InterruptGuard::interrupted() ? InterruptGuard::exit_code() : exit_done;
}

}  // namespace

void add_study_stability(base::Command& study, const Program& program) {
  base::Command& command = study.add_command(
      "stability", "named hard cases with each strategy, remeshing on and off: a verdict for each, failures included");
  auto arguments = std::make_shared<StabilityArguments>();
  StabilityOptions& options = arguments->options;
  command.add(
      {.name = "--list", .target = &arguments->list, .help = "name the cases and what has to hold, and run nothing"});
  command.add({.name = "--cases",
               .target = &options.cases,
               .help = "cases, separated by commas (default: all but those that take long)",
               .names = case_names()});
  add_areas(command, options.areas, *program.catalogue);
  command.add({.name = "--remeshing",
               .target = &arguments->remeshing,
               .help = "on, off or both",
               .names = {"on", "off", "both"},
               .names_only = true});
  command.add({.name = "--quick", .target = &arguments->quick, .help = "a twentieth of the steps"});
  command.add({.name = "--steps-scale", .target = &options.steps_scale, .help = "multiplies the number of steps"});
  command.add({.name = "--set",
               .target = &options.assignments,
               .help = "key=value: an option that every case is simulated with; may be given several times",
               .list = base::Argument::List::words,
               .assigns = all_option_specs(*program.catalogue)});
  command.add({.name = "--case-seconds",
               .target = &options.most_seconds,
               .help = "wall time after which a motion is stopped and fails"});
  add_output(command, arguments->out, arguments->force, "stability.csv");
  add_quiet(command, arguments->quiet);
  add_threads(command, arguments->threads);
  command.set_action([arguments] { return study_stability_command(*arguments); });
}

}  // namespace foamsim::app
