#include <cstdio>
#include <memory>

#include "Base/error.h"
#include "FoamSim/app/commands.h"
#include "FoamSim/app/common_arguments.h"
#include "FoamSim/app/pictures.h"
#include "FoamSim/app/scene_arguments.h"
#include "FoamSim/app/session.h"
#include "FoamSim/run/compare.h"

namespace foamsim::app {
namespace {

struct CompareArguments {
  SceneArguments scene;
  std::vector<std::string> areas{"naive", "constant-edge", "averaged"};
  bool no_pictures = false;
  std::string show;
};

std::string two_digits(const std::optional<double>& angle) {
  char text[32] = "-";
  if (angle) std::snprintf(text, sizeof(text), "%.2f", *angle);
  return text;
}

void print_table(const std::vector<ComparisonRow>& rows) {
  std::printf("\n%-14s %12s %12s %12s %14s %10s %9s %8s  %s\n", "strategy", "outer angle", "RMS dev.", "of films",
              "centroid drift", "energy", "volume", "seconds", "ended");
  std::printf("%-14s %12s %12s %12s %14s %10s %9s %8s\n", "", "degrees", "degrees", "degrees", "L", "L^5/T^2", "drift",
              "");
  for (const ComparisonRow& row : rows)
    std::printf("%-14s %12s %12s %12s %14.5f %10.4f %8.2f%% %8.1f  %s at time %g\n", row.area.c_str(),
                two_digits(row.angle_outer_mean_deg).c_str(), two_digits(row.angle_rms_deg).c_str(),
                two_digits(row.angle_rms_film_deg).c_str(), row.centroid_drift, row.energy, 100 * row.volume_drift_max,
                row.seconds, row.ended.c_str(), row.time);
}

int compare(const CompareArguments& arguments, const Program& program) {
  const SceneArguments& given = arguments.scene;
  if (!arguments.show.empty()) {
    print_table(read_comparison(std::filesystem::path(arguments.show) / "compare.csv"));
    return exit_done;
  }
  if (given.scene.empty()) throw base::InputError("compare needs a scene (see 'foamsim scenes')");
  const Scene scene = given.load(program, arguments.areas);
  RunSettings settings{given.out, given.force, {}, given.stop(), program.command_line};
  if (settings.out.empty()) settings.out = std::filesystem::path("out") / ("compare-" + scene.name);
  const ThreadLimit limit = thread_limit(given.threads);
  const InterruptGuard guard;
  std::unique_ptr<Progress> progress;
  const auto runs = compare_areas(scene, arguments.areas, settings, [&](const std::string& area) {
    progress = std::make_unique<Progress>(area, given.quiet);
    return hooks_for(*progress);
  });
  progress.reset();
  if (!given.quiet) print_table(read_comparison(settings.out / "compare.csv"));
  if (runs.back().outcome.end == RunEnd::interrupted) return InterruptGuard::exit_code();
  if (!arguments.no_pictures) {
    std::vector<std::filesystem::path> rows;
    rows.reserve(runs.size());
    for (const ComparedRun& run : runs) rows.push_back(run.outcome.directory);
    draw_frames(rows, 3, settings.out / "compare.png");
    plot(program, "plot_compare.py", settings.out);
  }
  if (!given.quiet) std::printf("\noutput in %s\n", settings.out.c_str());
  const bool failed = std::ranges::any_of(runs, [](const auto& run) { return run.outcome.end == RunEnd::failed; });
  return failed ? exit_cannot_go_on : exit_done;
}

}  // namespace

void add_compare_command(base::Command& root, const Program& program) {
  base::Command& command = root.add_command("compare", "run a scene with each area strategy: table, plot, pictures");
  auto arguments = std::make_shared<CompareArguments>();
  arguments->scene.add_to(command, program, false);
  add_areas(command, arguments->areas, *program.catalogue);
  command.add({.name = "--no-pictures", .target = &arguments->no_pictures, .help = "table only"});
  command.add({.name = "--show",
               .target = &arguments->show,
               .help = "print the table of an earlier comparison, in this folder, again",
               .offers = base::Argument::Offers::folders});
  command.set_action([arguments, &program] { return compare(*arguments, program); });
}

}  // namespace foamsim::app
