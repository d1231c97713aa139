#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "LosTopos/error.h"
#include "LosTopos/io/mesh_file.h"
#include "LosTopos/mesh/measures.h"
#include "MultiTracker/flows/advect.h"
#include "MultiTracker/scenes/scene.h"

namespace {

constexpr int exit_bad_input = 2, exit_failed = 3;

struct Arguments {
  std::string scene, mesh, out;
  long subdivisions = 3, steps = 300;
  double resolution = 0;
  bool fixed = false;
};

double enclosed_volume(const lostopos::SurfaceMesh& mesh) {
  double sum = 0;
  for (const auto& [region, volume] : lostopos::region_volumes(mesh))
    if (region != lostopos::air) sum += volume;
  return sum;
}

void run(const Arguments& arguments) {
  const multitracker::SceneEntry& scene = multitracker::scene_by_name(arguments.scene);
  if (arguments.steps < 1) throw lostopos::InputError("--steps has to be a whole number >= 1");
  if (arguments.subdivisions < 0 || arguments.subdivisions > 8)
    throw lostopos::InputError("--subdivisions has to be 0 to 8");
  if (!arguments.out.empty() && lostopos::find_mesh_format(arguments.out) == nullptr)
    throw lostopos::InputError("--out " + arguments.out + " is not a mesh file; known are " +
                               lostopos::mesh_extensions());
  if (!(arguments.resolution >= 0)) throw lostopos::InputError("--resolution has to be a number >= 0");
  lostopos::SurfaceMesh start_mesh = arguments.mesh.empty() ? scene.surface(arguments.subdivisions)
                                                            : lostopos::to_mesh(lostopos::read_surface(arguments.mesh));
  lostopos::TrackerOptions options;
  options.resolution = arguments.resolution > 0 ? arguments.resolution : lostopos::mean_edge_length(start_mesh);
  options.remeshing = !arguments.fixed;
  const std::size_t start_triangles = start_mesh.triangle_count();
  lostopos::SurfaceTracker tracker(std::move(start_mesh), options);
  const auto flow = scene.flow();
  const double volume = enclosed_volume(tracker.mesh()), dt = flow->period() / static_cast<double>(arguments.steps);
  lostopos::RemeshStatistics done;
  for (long step = 0; step < arguments.steps; ++step) {
    multitracker::advect(tracker, *flow, static_cast<double>(step) * dt, dt);
    done += tracker.remesh();
  }
  std::printf("%s: %zu -> %zu triangles, %ld steps over one period %g, %zu remeshing operations\n", scene.name.data(),
              start_triangles, tracker.mesh().triangle_count(), arguments.steps, flow->period(), done.done_in_all());
  const double end_volume = enclosed_volume(tracker.mesh());
  std::printf("volume %.6g -> %.6g (%+.3f%%)\n", volume, end_volume, 100 * (end_volume / volume - 1));
  if (!arguments.out.empty()) lostopos::write_surface(arguments.out, lostopos::from_mesh(tracker.mesh()));
}

int run_program(int argc, char** argv) {
  CLI::App app{"multitracker: moves a tracked surface by a prescribed flow", "multitracker"};
  app.require_subcommand(1);
  Arguments arguments;
  CLI::App* command = app.add_subcommand("run", "move a surface through one period of a flow");
  command->add_option("scene", arguments.scene, "see 'multitracker scenes'")->required();
  command->add_option("--mesh", arguments.mesh, "start from this mesh file instead of the scene's sphere");
  command->add_option("--subdivisions", arguments.subdivisions, "of the scene's sphere")->capture_default_str();
  command->add_option("--steps", arguments.steps, "steps in a period")->capture_default_str();
  command->add_option("--resolution", arguments.resolution, "target mean edge length; 0: that of the start mesh");
  command->add_flag("--fixed", arguments.fixed, "no remeshing: the triangles stay what they are");
  command->add_option("--out", arguments.out, "mesh file for the surface at the end");
  command->callback([&arguments] { run(arguments); });
  app.add_subcommand("scenes", "list the scenes")->callback([] {
    for (const auto& entry : multitracker::scene_entries())
      std::printf("%-10s %s\n", entry.name.data(), entry.summary.data());
  });
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);
    throw lostopos::InputError(std::string(error.what()) + " (see 'multitracker --help')");
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run_program(argc, argv);
  } catch (const lostopos::InputError& error) {
    std::fprintf(stderr, "multitracker: %s\n", error.what());
    return exit_bad_input;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "multitracker: %s\n", error.what());
    return exit_failed;
  }
}
