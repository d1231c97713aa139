#include <cstdio>
#include <memory>
#include <optional>

#include "Base/console/interrupt_guard.h"
#include "Base/console/progress.h"
#include "Base/console/thread_limit.h"
#include "Base/error.h"
#include "LosTopos/io/mesh_file.h"
#include "MultiTracker/app/commands.h"
#include "MultiTracker/run/run.h"
#include "MultiTracker/run/run_json.h"

namespace multitracker::app {
namespace {

struct Arguments {
  std::string scene, mesh, out;
  std::vector<std::string> assignments;
  std::optional<long> steps, seed;
  int threads = 0;
  bool quiet = false, audit = false, force = false;
};

base::OptionSet options_from(const Arguments& arguments, const SceneEntry& scene) {
  base::OptionSet options = options_of(scene);
  for (const std::string& assignment : arguments.assignments) options.set_assignment(assignment, "--set");
  if (arguments.steps) options.set("steps", *arguments.steps, "--steps");
  if (arguments.seed) options.set("seed", *arguments.seed, "--seed");
  return options;
}

void print_summary(const RunOutcome& outcome, const Arguments& arguments) {
  const Metrics &a = outcome.start, &b = outcome.last;
  std::printf("%s after step %ld (time %g): %zu -> %zu triangles, %zu -> %zu regions, %.1f s\n", name(outcome.end),
              b.step, b.time, a.triangles, b.triangles, a.regions, b.regions, outcome.wall_seconds);
  std::printf("area %.6g -> %.6g, shared by two regions %.6g -> %.6g, air's side %.6g -> %.6g, %zu junction edges\n",
              a.area, b.area, a.shared_area, b.shared_area, a.air_area, b.air_area, b.junction_edges);
  std::printf("largest change of a volume %.3g%%\n", 100 * b.volume_drift_max);
  std::printf("topology:");
  for (std::size_t i = 0; i < lostopos::topology_operation_count; ++i)
    std::printf(" %zu %s,", outcome.topology.operations[i].done,
                lostopos::name(static_cast<lostopos::TopologyOperation>(i)));
  std::printf(" %zu vertices left incomplete\n", outcome.topology.incomplete_vertices);
  if (!arguments.out.empty()) std::printf("output in %s\n", arguments.out.c_str());
}

int exit_code_of(RunEnd end) {
  if (end == RunEnd::interrupted) return exit_interrupted;
  return end == RunEnd::failed ? exit_failed : exit_done;
}

int run_scene(const Arguments& arguments, const Program& program) {
  const SceneEntry& scene = scene_by_name(arguments.scene);
  const base::OptionSet options = options_from(arguments, scene);
  if (arguments.threads < 0) throw base::InputError("--threads has to be a whole number >= 1");
  const base::ThreadLimit limit(arguments.threads);
  std::optional<lostopos::SurfaceMesh> surface;
  if (!arguments.mesh.empty()) surface = lostopos::to_mesh(lostopos::read_surface(arguments.mesh));
  Tracking tracking(scene, options, std::move(surface));
  const base::InterruptGuard guard;
  const RunOutcome outcome = [&] {
    base::Progress progress(arguments.scene, arguments.quiet);
    return run(tracking, options.whole("steps"), options.whole("frame_every"),
               {arguments.out, arguments.force, arguments.audit},
               {[&](const Metrics& m, double fraction) { progress.show(m.step, m.time, fraction); },
                [] { return base::InterruptGuard::interrupted(); }});
  }();
  if (!arguments.out.empty())
    write_run_json(std::filesystem::path(arguments.out) / "run.json",
                   {MULTITRACKER_VERSION, program.command_line, arguments.scene, arguments.mesh}, options, outcome);
  if (outcome.end == RunEnd::failed)
    std::fprintf(stderr, "multitracker: %s\nmultitracker: the last good state is %s\n", outcome.message.c_str(),
                 arguments.out.empty() ? "not saved; give --out DIR" : outcome.last_frame.c_str());
  if (!arguments.quiet) print_summary(outcome, arguments);
  return exit_code_of(outcome.end);
}

}  // namespace

void add_run_command(CLI::App& app, Program& program) {
  CLI::App* command = app.add_subcommand("run", "move a surface by a scene's flow");
  auto a = std::make_shared<Arguments>();
  command->add_option("scene", a->scene, "see 'multitracker scenes', which also lists the keys of --set")->required();
  command->add_option("--mesh", a->mesh, "start from this mesh file instead of the scene's own surface");
  command->add_option("--set", a->assignments, "key=value; repeat for more (see 'multitracker scenes SCENE')")
      ->type_size(1)
      ->allow_extra_args(false);
  command->add_option("--steps", a->steps, "number of steps");
  command->add_option("--seed", a->seed, "seed of everything random");
  command->add_option("--out", a->out, "folder for run.json, metrics.csv, volumes.csv, events.csv and frames");
  command->add_flag("--force", a->force, "replace a run that the folder holds");
  command->add_option("--threads", a->threads, "number of threads (default: all cores); results do not depend on it");
  command->add_flag("--audit", a->audit, "audit the surface after every step, and stop when it is not clean");
  command->add_flag("--quiet", a->quiet, "print nothing but errors");
  command->callback([a, &program] { program.exit_code = run_scene(*a, program); });
}

}  // namespace multitracker::app
