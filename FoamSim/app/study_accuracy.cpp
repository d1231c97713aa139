#include <cstdio>
#include <memory>

#include "Base/io/csv_table.h"
#include "FoamSim/app/pictures.h"
#include "FoamSim/app/session.h"
#include "FoamSim/app/study_commands.h"
#include "FoamSim/studies/accuracy/accuracy_csv.h"

namespace foamsim::app {

namespace {

struct Arguments {
  AccuracyOptions options;
  std::string out = "out/accuracy";
  bool fixed_mesh = false, no_evolver = false, quiet = false, force = false;
  int threads = 0;
};

void print_header() {
  std::printf("%-14s %4s %-6s %6s %9s %9s %8s %8s %8s %8s %8s %8s %8s %8s\n", "strategy", "N", "scheme", "dt",
              "triangles", "area", "radius", "rim", "wall", "pressure", "facets", "films", "volume", "CPU s");
  std::printf("%-14s %4s %-6s %6s %9s %9s %8s %8s %8s %8s %8s %8s %8s %8s\n", "", "", "", "", "", "error", "error",
              "error", "error", "error", "RMS deg", "RMS deg", "drift", "to rest");
}

std::string degrees(const std::optional<double>& angle) {
  char text[32] = "-";
  if (angle) std::snprintf(text, sizeof(text), "%.3f", *angle);
  return text;
}

void print(const AccuracyRow& row) {
  std::printf("%-14s %4ld %-6s %6g %9zu ", row.area.c_str(), row.n, row.integrator.c_str(), row.dt, row.triangles);
  if (row.errors) {
    const EquilibriumErrors& e = *row.errors;
    std::printf("%8.3f%% %7.2f%% %7.2f%% %7.2f%% %7.2f%% %8s %8s ", 100 * e.area, 100 * e.radius, 100 * e.rim,
                100 * e.wall, 100 * e.pressure, degrees(e.angle_rms_deg).c_str(),
                degrees(e.angle_rms_film_deg).c_str());
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

int study_accuracy_command(Arguments& arguments) {
  AccuracyOptions& options = arguments.options;
  options.remeshing = !arguments.fixed_mesh;
  validate(options);
  const std::filesystem::path out = arguments.out;
  require_new_study(out, "accuracy.csv", arguments.force);
  const ThreadLimit limit(arguments.threads);
  const InterruptGuard guard;
  base::CsvTable table(out / "accuracy.csv", accuracy_csv_header());
  print_header();
  {
    Progress progress("accuracy", arguments.quiet);
    study_accuracy(options,
                   {.row =
                        [&](const AccuracyRow& row) {
                          progress.clear();
                          table.add(accuracy_csv_row(row));
                          print(row);
                        },
                    .progress = [&](const std::string& label, double fraction) { progress.show(label, fraction); },
                    .interrupted = InterruptGuard::interrupted});
  }
  if (!InterruptGuard::interrupted() && !arguments.no_evolver) run_plot_script("measure_evolver.py", out);
  plot_study("plot_accuracy.py", out);
  std::printf("output in %s\n", out.c_str());
  return InterruptGuard::interrupted() ? exit_interrupted : exit_done;
}

}  // namespace

void add_study_accuracy(CLI::App& study, Program& program) {
  CLI::App* command = study.add_subcommand(
      "accuracy", "double bubbles brought to rest: errors against the closed form, and what they cost in time");
  auto arguments = std::make_shared<Arguments>();
  AccuracyOptions& options = arguments->options;
  auto* sizes = command->add_option("--sizes", options.sizes, "N, separated by commas")->delimiter(',');
  command->add_option("--areas", options.areas, "strategies, separated by commas")->delimiter(',');
  auto* schemes = command->add_option("--integrators", options.integrators, "euler, rk4")->delimiter(',');
  auto* steps =
      command->add_option("--dt", options.steps_of_time, "lengths of a step, separated by commas")->delimiter(',');
  command->add_option("--damping", options.damping, "factor by which circulation decays in a unit of time")
      ->capture_default_str();
  auto* time = command->add_option("--time", options.most_time, "simulated time after which a run ends without rest")
                   ->capture_default_str();
  command->add_flag("--fixed-mesh", arguments->fixed_mesh, "without remeshing");
  command
      ->add_flag_callback(
          "--quick", [&options] { make_quick(options); },
          "N = 8, 12, 16 with euler and dt 0.02: seconds instead of minutes")
      ->excludes(sizes)
      ->excludes(schemes)
      ->excludes(steps)
      ->excludes(time);
  command->add_flag("--no-evolver", arguments->no_evolver, "do not measure Surface Evolver, where it is installed");
  command->add_option("--out", arguments->out, "folder for accuracy.csv and the plot")->capture_default_str();
  command->add_flag("--force", arguments->force, "replace a study that the folder holds");
  command->add_flag("--quiet", arguments->quiet, "no progress");
  command->add_option("--threads", arguments->threads, "number of threads (default: all cores)");
  command->callback([arguments, &program] { program.exit_code = study_accuracy_command(*arguments); });
}

}  // namespace foamsim::app
