#include <cstdio>
#include <memory>

#include "Base/io/csv_table.h"
#include "FoamSim/app/common_arguments.h"
#include "FoamSim/app/pictures.h"
#include "FoamSim/app/session.h"
#include "FoamSim/app/study_commands.h"
#include "FoamSim/studies/accuracy/accuracy_csv.h"

namespace foamsim::app {

namespace {

struct AccuracyArguments {
  AccuracyOptions options;
  std::string out = "out/accuracy";
  bool fixed_mesh = false, no_evolver = false, quiet = false, force = false;
  int threads = 0;
};

void print_accuracy_header() {
  std::printf("%-14s %4s %-6s %6s %9s %9s %8s %8s %8s %8s %8s %8s %8s %8s\n", "strategy", "N", "scheme", "dt",
              "triangles", "area", "radius", "rim", "wall", "pressure", "facets", "films", "volume", "CPU s");
  std::printf("%-14s %4s %-6s %6s %9s %9s %8s %8s %8s %8s %8s %8s %8s %8s\n", "", "", "", "", "", "error", "error",
              "error", "error", "error", "RMS deg", "RMS deg", "drift", "to rest");
}

std::string three_digits(const std::optional<double>& angle) {
  char text[32] = "-";
  if (angle) std::snprintf(text, sizeof(text), "%.3f", *angle);
  return text;
}

void print_accuracy(const AccuracyRow& row) {
  std::printf("%-14s %4ld %-6s %6g %9zu ", row.area.c_str(), row.n, row.integrator.c_str(), row.dt, row.triangles);
  if (row.errors) {
    const EquilibriumErrors& e = *row.errors;
    std::printf("%8.3f%% %7.2f%% %7.2f%% %7.2f%% %7.2f%% %8s %8s ", 100 * e.area, 100 * e.radius, 100 * e.rim,
                100 * e.wall, 100 * e.pressure, three_digits(e.angle_rms_deg).c_str(),
                three_digits(e.angle_rms_film_deg).c_str());
  }
  std::printf("%7.2f%% %8.2f", 100 * row.volume_drift, row.cpu_seconds);
  if (row.ended != "at rest") std::printf("  %s at time %g", row.ended.c_str(), row.time);
  std::printf("%s%s\n", row.reason.empty() ? "" : ": ", row.reason.c_str());
  std::fflush(stdout);
}

// Seconds instead of minutes.
void make_quick(AccuracyOptions& options) {
  options.sizes = {8, 12, 16};
  options.integrators = {"euler"};
  options.steps_of_time = {0.02};
  options.most_time = 8;
}

int study_accuracy_command(AccuracyArguments& arguments, const Program& program) {
  AccuracyOptions& options = arguments.options;
  options.remeshing = !arguments.fixed_mesh;
  validate(options);
  const std::filesystem::path out = arguments.out;
  require_new_study(out, "accuracy.csv", arguments.force);
  const ThreadLimit limit = thread_limit(arguments.threads);
  const InterruptGuard guard;
  base::CsvTable table(out / "accuracy.csv", accuracy_csv_header());
  print_accuracy_header();
  {
    Progress progress("accuracy", arguments.quiet);
    study_accuracy(options,
                   {.row =
                        [&](const AccuracyRow& row) {
                          progress.clear();
                          table.add(accuracy_csv_row(row));
                          print_accuracy(row);
                        },
                    .progress = [&](const std::string& label, double fraction) { progress.show(label, fraction); },
                    .interrupted = InterruptGuard::interrupted});
  }
  if (!InterruptGuard::interrupted() && !arguments.no_evolver) run_plot_script("measure_evolver.py", out);
  plot(program, "plot_accuracy.py", out);
  std::printf("output in %s\n", out.c_str());
  return InterruptGuard::interrupted() ? InterruptGuard::exit_code() : exit_done;
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
  add_output(command, arguments->out, arguments->force, "accuracy.csv and the plot");
  add_quiet(command, arguments->quiet);
  add_threads(command, arguments->threads);
  command.set_action([arguments, &program] { return study_accuracy_command(*arguments, program); });
}

}  // namespace foamsim::app
