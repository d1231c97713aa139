#include <cstdio>
#include <memory>

#include "Base/io/write_error.h"
#include "FoamSim/app/commands.h"
#include "FoamSim/app/common_arguments.h"
#include "FoamSim/app/pictures.h"
#include "FoamSim/app/session.h"
#include "FoamSim/studies/reproduce/angle_measures.h"
#include "FoamSim/studies/reproduce/figure1.h"
#include "FoamSim/studies/reproduce/scene_gallery.h"
#include "FoamSim/studies/reproduce/stretched_junction.h"
#include "FoamSim/studies/reproduce/table1.h"

namespace foamsim::app {

namespace fs = std::filesystem;

namespace {

struct ReproduceArguments {
  std::string what, out = "out/reproduce";
  bool quick = false, force = false, quiet = false;
  int threads = 0;
};

std::string text(const std::optional<double>& value, const char* format = "%.2f") {
  char cell[32] = "-";
  if (value) std::snprintf(cell, sizeof(cell), format, *value);
  return cell;
}

void print_table1_header() {
  std::printf("%-14s %4s %17s %9s %9s %7s %10s %8s %8s %9s %6s %9s %9s  %s\n", "strategy", "N", "triangles", "RMS dev.",
              "of films", "exact", "published", "differ.", "outer", "height", "steps", "CPU s", "wall s", "ended");
}

void print_row(const Table1Row& r) {
  const std::string triangles = std::to_string(r.triangles_start) + " -> " + std::to_string(r.triangles);
  std::printf("%-14s %4ld %17s %9s %9s %7.2f %10s %8s %8s %9s %6ld %9.1f %9.1f  %s at time %.2f\n", r.area.c_str(), r.n,
              triangles.c_str(), text(r.angle_rms_deg).c_str(), text(r.angle_rms_film_deg).c_str(), r.exact_facets_deg,
              text(r.published_deg).c_str(), text(r.difference_deg(), "%+.2f").c_str(),
              text(r.angle_outer_mean_deg).c_str(), text(r.border_height, "%.4f").c_str(), r.steps, r.cpu_seconds,
              r.wall_seconds, r.ended.c_str(), r.time);
  std::fflush(stdout);
}

// Each of these makes one part; false when interrupted.

bool measures(const ReproduceArguments& arguments) {
  const auto rows = measure_exact_double_bubbles();
  base::make_folder(arguments.out);
  write_angle_measures(fs::path(arguments.out) / "angle_measures.csv", rows);
  std::printf("What the two measures find where every angle is 120 degrees (vertices exactly on double bubbles):\n");
  std::printf("%-14s %8s %9s %8s %12s %12s\n", "volumes", "segments", "triangles", "h/R", "facets, deg", "films, deg");
  for (const MeasuredExactly& r : rows)
    std::printf("1 : %-10g %8ld %9zu %8.3f %12.3f %12.4f\n", r.volume_ratio, r.segments, r.triangles, r.h_over_radius,
                r.facets_rms_deg, r.films_rms_deg);
  return true;
}

bool table1(const ReproduceArguments& arguments, const Program& program) {
  Table1Settings settings;
  if (arguments.quick) settings.subdivisions.pop_back();
  settings.out = arguments.out;
  settings.force = arguments.force;
  settings.command = program.command_line;
  std::unique_ptr<Progress> progress;
  Table1Hooks hooks;
  // One clock for the whole table: the time left is that of all rows.
  hooks.run = [&](const std::string& area, long n, double begin, double end) {
    if (!progress) progress = std::make_unique<Progress>("table 1", arguments.quiet);
    progress->relabel("table 1: " + area + ", N = " + std::to_string(n));
    return RunHooks{[&progress, begin, end](long step, double time, double fraction) {
                      progress->show(step, time, begin + fraction * (end - begin));
                    },
                    [] { return InterruptGuard::interrupted(); }, [] { return InterruptGuard::interrupted(); }};
  };
  hooks.row = [&](const Table1Row& row) {
    progress->clear();
    if (!arguments.quiet) print_row(row);
  };
  if (!arguments.quiet) print_table1_header();
  const auto rows = make_table1(settings, hooks);
  progress.reset();
  if (!arguments.quiet) {
    std::printf("\n");
    print_table1_header();
    for (const std::string& area : settings.areas)
      for (const Table1Row& row : rows)
        if (row.area == area) print_row(row);
  }
  if (rows.size() > 1) plot(program, "plot_table1.py", arguments.out);
  return rows.size() == settings.subdivisions.size() * settings.areas.size();
}

bool figure1(const ReproduceArguments& arguments, const Program& program) {
  RunSettings settings;
  settings.out = fs::path(arguments.out) / "figure1";
  settings.command = program.command_line;
  settings.force = true;
  const fs::path sheet = settings.out / "figure1_frames.png";  // made last: where it is, all is
  if (arguments.force || !fs::exists(sheet)) {
    fs::remove(sheet);
    std::unique_ptr<Progress> progress;
    const Figure1Options options;
    const auto runs = run_figure1(options, settings, [&](const std::string& area) {
      progress = std::make_unique<Progress>("figure 1: " + area, arguments.quiet);
      return hooks_for(*progress);
    });
    progress.reset();
    if (runs.back().outcome.end == RunEnd::interrupted) return false;
    std::vector<fs::path> rows;
    rows.reserve(runs.size());
    for (const ComparedRun& run : runs) rows.push_back(run.outcome.directory);
    draw_frames(rows, static_cast<std::size_t>(options.frames) + 1, sheet);
  }
  const auto rows = read_comparison(settings.out / "compare.csv");
  if (!arguments.quiet)
    for (const ComparisonRow& row : rows)
      std::printf("figure 1: %-14s outer angle %s, RMS deviation %s, centroid drift %.4f, volume drift %.2f%%\n",
                  row.area.c_str(), text(row.angle_outer_mean_deg).c_str(), text(row.angle_rms_deg).c_str(),
                  row.centroid_drift, 100 * row.volume_drift_max);
  if (!arguments.quiet)
    std::printf("figure 1: naive drifts %.1f times as far as constant-edge, %.1f times as far as averaged\n",
                drift_ratio(rows, "constant-edge"), drift_ratio(rows, "averaged"));
  plot(program, "plot_figure1.py", settings.out);
  return true;
}

bool figure3(const ReproduceArguments& arguments, const Program& program) {
  const auto rows = stretch_junction();
  base::make_folder(arguments.out);
  write_stretched_junction(fs::path(arguments.out) / "figure3.csv", rows);
  if (!arguments.quiet)
    for (const StretchedJunctionRow& row : rows)
      std::printf("figure 3: %-14s stretch %-4g curvature of regions 0, 1, 2: %.5f %.5f %.5f  imbalance %.5f\n",
                  row.area.c_str(), row.stretch, row.curvature[0], row.curvature[1], row.curvature[2], row.imbalance());
  plot(program, "plot_figure3.py", arguments.out);
  return true;
}

// A picture of each scene, and a table of the figures that scenes are known by.
bool scenes(const ReproduceArguments& arguments) {
  const fs::path folder = fs::path(arguments.out) / "scenes";
  base::make_folder(folder);
  std::vector<GalleryRow> rows;
  for (const GalleryScene& scene : gallery_scenes()) {
    Progress progress("scenes: " + scene.scene, arguments.quiet);
    GalleryHooks hooks;
    hooks.stepped = [&](const Simulation& s, double fraction) { progress.show(s.steps(), s.time(), fraction); };
    hooks.interrupted = [] { return InterruptGuard::interrupted(); };
    hooks.picture = [&](const Simulation& s) { draw_films(s, scene.view, folder / (scene.scene + ".png")); };
    const std::vector<GalleryRow> of_scene = run_gallery_scene(scene, hooks);
    progress.clear();
    if (InterruptGuard::interrupted()) return false;
    for (const GalleryRow& r : of_scene) {
      rows.push_back(r);
      if (!arguments.quiet)
        std::printf("%-20s %-32s at %-5.3g measured %-10.6g expected %-10.6g (%s) %s, %.1f CPU s\n", r.scene.c_str(),
                    r.quantity.c_str(), r.time, r.measured, r.expected, r.source.c_str(), r.holds() ? "holds" : "OFF",
                    r.cpu_seconds);
    }
    write_gallery(folder / "scenes.csv", rows);
  }
  return true;
}

int reproduce(const ReproduceArguments& arguments, const Program& program) {
  const ThreadLimit limit = thread_limit(arguments.threads);
  const InterruptGuard guard;
  const bool all = arguments.what == "all";
  bool whole = true;
  if (all || arguments.what == "measures") whole = measures(arguments);
  if (all || arguments.what == "figure3") whole = whole && figure3(arguments, program);
  if (all || arguments.what == "figure1") whole = whole && figure1(arguments, program);
  if (all || arguments.what == "table1") whole = whole && table1(arguments, program);
  if (arguments.what == "scenes") whole = scenes(arguments);
  if (!arguments.quiet)
    std::printf("output in %s%s\n", arguments.out.c_str(),
                whole ? "" : "; interrupted: the same command goes on with what is there");
  return whole ? exit_done : InterruptGuard::exit_code();
}

}  // namespace

void add_reproduce_command(base::Command& root, const Program& program) {
  base::Command& command = root.add_command("reproduce", "the report's table and figures, beside the published values");
  auto arguments = std::make_shared<ReproduceArguments>();
  command.add(
      {.name = "what",
       .target = &arguments->what,
       .help =
           "table1, figure1, figure3, measures (the angle measures' own error), all of these, or scenes (a picture and "
           "figures of each built-in scene)",
       .required = true,
       .names = {"table1", "figure1", "figure3", "measures", "all", "scenes"},
       .names_only = true});
  command.add({.name = "--quick",
               .target = &arguments->quick,
               .help = "table1 without N = 96: minutes instead of most of an hour"});
  add_output(command, arguments->out, arguments->force, "the output; without --force what it holds is not made again");
  add_threads(command, arguments->threads);
  add_quiet(command, arguments->quiet);
  command.set_action([arguments, &program] { return reproduce(*arguments, program); });
}

}  // namespace foamsim::app
