#include <cstdio>
#include <memory>

#include "Base/options/option_value.h"
#include "FoamSim/app/common_arguments.h"
#include "FoamSim/app/pictures.h"
#include "FoamSim/app/session.h"
#include "FoamSim/app/study_commands.h"
#include "FoamSim/app/study_sweep.h"
#include "FoamSim/studies/accuracy/accuracy_csv.h"

namespace foamsim::app {

namespace {

struct AccuracyArguments {
  AccuracyOptions options;
  StudyWays ways{.out = "out/accuracy"};
  bool fixed_mesh = false, no_evolver = false;
};

void print_accuracy_header() {
  std::printf("%-14s %4s %-6s %6s %9s %9s %8s %8s %8s %8s %8s %8s %8s %8s\n", "strategy", "N", "scheme", "dt",
              "triangles", "area", "radius", "rim", "wall", "pressure", "facets", "films", "volume", "CPU s");
  std::printf("%-14s %4s %-6s %6s %9s %9s %8s %8s %8s %8s %8s %8s %8s %8s\n", "", "", "", "", "", "error", "error",
              "error", "error", "error", "RMS deg", "RMS deg", "drift", "to rest");
}

// A cell of the table as it is printed; empty ones as a dash.
std::string cell(const StudyRow& row, const char* column, const char* format, double factor = 1) {
  const std::string& text = row.at(column);
  char printed[32] = "-";
  if (!text.empty()) std::snprintf(printed, sizeof(printed), format, factor * std::stod(text));
  return printed;
}

void print_accuracy(const StudyRow& row) {
  std::printf("%-14s %4s %-6s %6s %9s", row.at("area").c_str(), row.at("n").c_str(), row.at("integrator").c_str(),
              cell(row, "dt", "%g").c_str(), row.at("triangles").c_str());
  std::printf(" %9s", cell(row, "area_error", "%.3f%%", 100).c_str());
  for (const char* column : {"radius_error", "rim_error", "wall_error", "pressure_error"})
    std::printf(" %8s", cell(row, column, "%.2f%%", 100).c_str());
  for (const char* column : {"angle_rms_deg", "angle_rms_film_deg"})
    std::printf(" %8s", cell(row, column, "%.3f").c_str());
  std::printf(" %8s %8s", cell(row, "volume_drift", "%.2f%%", 100).c_str(), cell(row, "cpu_seconds", "%.2f").c_str());
  if (row.at("ended") != "at rest")
    std::printf("  %s at time %s", row.at("ended").c_str(), cell(row, "time", "%g").c_str());
  std::printf("%s%s\n", row.at("reason").empty() ? "" : ": ", row.at("reason").c_str());
  std::fflush(stdout);
}

// Seconds instead of minutes.
void make_quick(AccuracyOptions& options) {
  options.sizes = {8, 12, 16};
  options.integrators = {"euler"};
  options.steps_of_time = {0.02};
  options.most_time = 8;
}

// What tells a row, and what all have.
StudyRows rows_of(const AccuracyArguments& arguments) {
  const AccuracyOptions& options = arguments.options;
  StudyRows study{.study = "accuracy",
                  .axes = {"sizes", "areas", "integrators", "dt"},
                  .rows = {},
                  .fixed = {"--damping", base::to_text(options.damping), "--time", base::to_text(options.most_time),
                            "--no-evolver"},
                  .header = accuracy_csv_header(),
                  .print = print_accuracy};
  if (arguments.fixed_mesh) study.fixed.emplace_back("--fixed-mesh");
  for (const AccuracyCombination& c : combinations(options))
    study.rows.push_back({std::to_string(c.n), c.area, c.integrator, base::to_text(c.dt)});
  return study;
}

int study_accuracy_command(AccuracyArguments& arguments, const Program& program) {
  arguments.options.remeshing = !arguments.fixed_mesh;
  validate(arguments.options);
  const StudyRows study = rows_of(arguments);
  const std::filesystem::path& out = arguments.ways.out;
  const InterruptGuard guard;
  if (!arguments.ways.plan) print_accuracy_header();
  const int code = make_study(study, arguments.ways, program, [&arguments](const RowHooks& hooks) {
    study_accuracy(arguments.options, {.row = [&](const AccuracyRow& row) { hooks.row(accuracy_csv_row(row)); },
                                       .progress = hooks.progress,
                                       .interrupted = hooks.interrupted});
  });
  if (arguments.ways.plan) return code;
  if (!InterruptGuard::interrupted() && !arguments.no_evolver) run_plot_script("measure_evolver.py", out);
  if (study.rows.size() > 1) plot(program, "plot_accuracy.py", out);
  std::printf("output in %s\n", out.c_str());
  return code;
}

}  // namespace

void add_study_accuracy(base::Command& study, const Program& program) {
  base::Command& command = study.add_command(
      "accuracy", "double bubbles brought to rest: errors against the closed form, and what they cost in time");
  auto arguments = std::make_shared<AccuracyArguments>();
  AccuracyOptions& options = arguments->options;
  command.add({.name = "--sizes", .target = &options.sizes, .help = "N, separated by commas"});
  add_areas(command, options.areas, *program.catalogue);
  command.add({.name = "--integrators",
               .target = &options.integrators,
               .help = "integrators, separated by commas",
               .names = {"euler", "rk4"}});
  command.add({.name = "--dt", .target = &options.steps_of_time, .help = "lengths of a step, separated by commas"});
  command.add({.name = "--damping",
               .target = &options.damping,
               .help = "factor by which circulation decays in a unit of time"});
  command.add(
      {.name = "--time", .target = &options.most_time, .help = "simulated time after which a run ends without rest"});
  command.add({.name = "--fixed-mesh", .target = &arguments->fixed_mesh, .help = "without remeshing"});
  command.add({.name = "--quick",
               .target = [&options] { make_quick(options); },
               .help = "N = 8, 12, 16 with euler and dt 0.02: seconds instead of minutes",
               .excludes = {"--sizes", "--integrators", "--dt", "--time"}});
  command.add({.name = "--no-evolver",
               .target = &arguments->no_evolver,
               .help = "do not measure Surface Evolver, where it is installed"});
  add_study_ways(command, arguments->ways, "accuracy.csv and the plot");
  command.set_action([arguments, &program] { return study_accuracy_command(*arguments, program); });
}

}  // namespace foamsim::app
