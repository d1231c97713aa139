#include <cstdio>
#include <memory>

#include "Base/error.h"
#include "Base/options/option_value.h"
#include "FoamSim/app/common_arguments.h"
#include "FoamSim/app/session.h"
#include "FoamSim/app/study_commands.h"
#include "FoamSim/app/study_sweep.h"
#include "FoamSim/scenes/methods.h"
#include "FoamSim/studies/stability/stability_csv.h"

namespace foamsim::app {

namespace {

// --quick makes a twentieth of the steps.
constexpr double quick_scale = 0.05;

struct StabilityArguments {
  StabilityOptions options;
  StudyWays ways{.out = "out/stability"};
  std::string remeshing = "both";
  bool list = false, quick = false;
};

void print_stability_header() {
  std::printf("%-17s %-14s %-5s %-7s %9s %9s %9s %8s  %s\n", "case", "strategy", "mesh", "verdict", "energy", "volume",
              "impulse", "seconds", "figure; reason");
  std::printf("%-17s %-14s %-5s %-7s %9s %9s %9s\n", "", "", "", "", "rise", "drift", "drift");
}

void print_verdict(const StudyRow& row) {
  const auto percent = [&row](const char* column) { return 100 * std::stod(row.at(column)); };
  std::printf("%-17s %-14s %-5s %-7s %8.3f%% %8.3f%% %8.3f%% %8.1f  ", row.at("case").c_str(), row.at("area").c_str(),
              row.at("remeshing") == "on" ? "moves" : "fixed", row.at("verdict") == "pass" ? "pass" : "FAIL",
              percent("energy_rise"), percent("volume_drift"), percent("impulse_drift"), std::stod(row.at("seconds")));
  if (!row.at("figure").empty())
    std::printf("%s %.4g; ", row.at("figure_name").c_str(), std::stod(row.at("figure")));
  else if (!row.at("figure_name").empty())
    std::printf("%s: none; ", row.at("figure_name").c_str());
  std::printf("%s\n", row.at("reason").c_str());
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

// What tells a row, and what all have.
StudyRows rows_of(const StabilityOptions& options) {
  StudyRows study{.study = "stability",
                  .axes = {"cases", "areas", "remeshing"},
                  .rows = {},
                  .fixed = {"--steps-scale", base::to_text(options.steps_scale), "--case-seconds",
                            base::to_text(options.most_seconds)},
                  .header = stability_csv_header(),
                  .print = {}};
  for (const std::string& assignment : options.assignments)
    study.fixed.insert(study.fixed.end(), {"--set", assignment});
  for (const StabilityCombination& c : combinations(options))
    study.rows.push_back({c.name, c.area, c.remeshing ? "on" : "off"});
  return study;
}

int study_stability_command(StabilityArguments& arguments, const Program& program) {
  if (arguments.list) return list_cases();
  StabilityOptions& options = arguments.options;
  options.remeshing = remeshing_from(arguments.remeshing);
  if (arguments.quick) options.steps_scale *= quick_scale;
  validate(options);
  const InterruptGuard guard;
  StudyRows study = rows_of(options);
  std::size_t passed = 0, all = 0;
  study.print = [&](const StudyRow& row) {
    print_verdict(row);
    ++all;
    passed += row.at("verdict") == "pass" ? 1 : 0;
  };
  if (!arguments.ways.plan) print_stability_header();
  const int code = make_study(study, arguments.ways, program, [&options](const RowHooks& hooks) {
    study_stability(options, {.row = [&](const StabilityRow& row) { hooks.row(stability_csv_row(row)); },
                              .progress = hooks.progress,
                              .interrupted = hooks.interrupted});
  });
  if (!arguments.ways.plan)
    std::printf("%zu of %zu passed; table in %s/stability.csv\n", passed, all, arguments.ways.out.c_str());
  return code;
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
  add_study_ways(command, arguments->ways, "stability.csv");
  command.set_action([arguments, &program] { return study_stability_command(*arguments, program); });
}

}  // namespace foamsim::app
