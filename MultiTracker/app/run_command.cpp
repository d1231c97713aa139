#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>

#include "Base/console/interrupt_guard.h"
#include "Base/console/progress.h"
#include "Base/console/terminal.h"
#include "Base/console/thread_limit.h"
#include "Base/error.h"
#include "LosTopos/io/mesh_file.h"
#include "LosTopos/io/tidy_surface.h"
#include "MultiTracker/app/commands.h"
#include "MultiTracker/run/run.h"
#include "MultiTracker/scenes/reference_options.h"

namespace multitracker::app {
namespace {

struct Arguments {
  std::string scene, mesh, out, resume;
  std::vector<std::string> assignments;
  std::optional<long> steps, seed;
  int threads = 0;
  bool quiet = false, audit = false, force = false;
};

void set_options(const Arguments& arguments, base::OptionSet& options) {
  for (const std::string& assignment : arguments.assignments) options.set_assignment(assignment, "--set");
  if (arguments.steps) options.set("steps", *arguments.steps, "--steps");
  if (arguments.seed) options.set("seed", *arguments.seed, "--seed");
}

void print_summary(const RunOutcome& outcome, const RunSettings& settings) {
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
  if (!settings.out.empty()) std::printf("output in %s\n", settings.out.c_str());
}

int exit_code_of(RunEnd end) {
  if (end == RunEnd::interrupted) return base::InterruptGuard::exit_code();
  return end == RunEnd::failed ? exit_cannot_go_on : exit_done;
}

lostopos::SurfaceMesh given_surface(const std::string& file, std::vector<std::string>& notes) {
  lostopos::SurfaceData data = lostopos::read_surface(file);
  for (const std::string& note : lostopos::tidy_surface(data))
    notes.push_back(std::string(file).append(": ").append(note));
  return lostopos::to_mesh(data);
}

// A scene by its name, or by an option file of the reference tracker.
ReferenceScene scene_of(const Arguments& arguments) {
  if (arguments.scene.empty()) throw base::InputError("run needs a scene (see 'multitracker scenes') or --resume FILE");
  if (std::filesystem::path(arguments.scene).extension() == ".txt") return read_reference_options(arguments.scene);
  const SceneEntry& scene = scene_by_name(arguments.scene);
  return {&scene, options_of(scene), {}, {}};
}

Origin origin_of(const Arguments& arguments, const Program& program) {
  ReferenceScene read = scene_of(arguments);
  set_options(arguments, read.options);
  if (!arguments.mesh.empty()) read.mesh_file = arguments.mesh;
  Origin origin{.scene = read.scene, .options = std::move(read.options), .mesh_file = read.mesh_file};
  if (!read.mesh_file.empty()) origin.given = given_surface(read.mesh_file, read.notes).state();
  for (const std::string& note : read.notes)
    if (!arguments.quiet) base::print_warning(program.name, note);
  return origin;
}

std::unique_ptr<Tracking> resumed(const Arguments& arguments, const base::Interruption& interruption) {
  if (!arguments.scene.empty() || !arguments.mesh.empty() || !arguments.assignments.empty() || arguments.seed)
    throw base::InputError("--resume goes on with the scene of the checkpoint; leave out the scene and its options");
  return Tracking::resumed(arguments.resume, interruption);
}

RunSettings settings_of(const Arguments& arguments, const Program& program) {
  namespace fs = std::filesystem;
  RunSettings settings{.out = arguments.out,
                       .force = arguments.force,
                       .audit = arguments.audit,
                       .call = {MULTITRACKER_VERSION, program.command_line}};
  if (arguments.resume.empty()) return settings;
  const fs::path file = arguments.resume;
  const fs::path folder = fs::is_directory(file)       ? file
                          : file.parent_path().empty() ? fs::path(".")
                                                       : file.parent_path();
  if (arguments.out.empty()) settings.out = folder;
  settings.go_on = fs::weakly_canonical(settings.out) == fs::weakly_canonical(folder);
  return settings;
}

void report(const RunOutcome& outcome, const RunSettings& settings, const Arguments& arguments,
            const Program& program) {
  if (outcome.end == RunEnd::failed) {
    base::print_error(program.name, outcome.message);
    base::print_error(program.name, "the last good state is " + (settings.out.empty() ? "not saved; give --out DIR"
                                                                                      : outcome.last_frame.string()));
  }
  if (arguments.quiet) return;
  print_summary(outcome, settings);
  if (outcome.end == RunEnd::interrupted && !outcome.checkpoint.empty())
    std::printf("to go on: %s run --resume %s%s\n", program.name.c_str(), outcome.checkpoint.c_str(),
                arguments.steps ? (" --steps " + std::to_string(*arguments.steps)).c_str() : "");
  else if (outcome.end != RunEnd::failed && !outcome.message.empty())
    std::printf("%s\n", outcome.message.c_str());
}

int run_scene(const Arguments& arguments, const Program& program) {
  if (arguments.threads < 0) throw base::InputError("--threads has to be a whole number >= 0");
  const base::ThreadLimit limit(arguments.threads);
  const bool resuming = !arguments.resume.empty();
  const base::Interruption interruption{[] { return base::InterruptGuard::interrupted(); }};
  const auto tracking = resuming ? resumed(arguments, interruption)
                                 : std::make_unique<Tracking>(origin_of(arguments, program), interruption);
  const RunSettings settings = settings_of(arguments, program);
  const long last_step = arguments.steps.value_or(tracking->origin().options.whole("steps"));
  if (last_step < 0) throw base::InputError("--steps has to be a whole number >= 0");
  const base::InterruptGuard guard;
  const RunOutcome outcome = [&] {
    base::Progress progress(std::string(tracking->origin().scene->name), arguments.quiet);
    return run(*tracking, last_step, settings,
               {[&](const Metrics& m, double fraction) { progress.show(m.step, m.time, fraction); },
                [] { return base::InterruptGuard::interrupted(); }});
  }();
  report(outcome, settings, arguments, program);
  return exit_code_of(outcome.end);
}

// Each key once, though several scenes may have it.
std::vector<base::OptionSpec> all_option_specs() {
  std::vector<base::OptionSpec> all = common_option_specs();
  for (const SceneEntry& entry : scene_entries())
    for (const base::OptionSpec& spec : entry.options)
      if (std::ranges::find(all, spec.key, &base::OptionSpec::key) == all.end()) all.push_back(spec);
  return all;
}

}  // namespace

std::vector<std::string> scene_names() {
  std::vector<std::string> names;
  for (const SceneEntry& entry : scene_entries()) names.emplace_back(entry.name);
  return names;
}

void add_run_command(base::Command& root, const Program& program) {
  using base::Argument;
  base::Command& command = root.add_command("run", "move a surface by a scene's flow");
  auto a = std::make_shared<Arguments>();
  command.add({.name = "scene",
               .target = &a->scene,
               .help =
                   "a name (see 'multitracker scenes', which also lists the keys of --set), or an option file of the "
                   "reference tracker (.txt)",
               .names = scene_names()});
  command.add({.name = "--resume",
               .target = &a->resume,
               .help = "go on from this checkpoint.cbor, or that of this folder",
               .offers = Argument::Offers::files});
  command.add({.name = "--mesh",
               .target = &a->mesh,
               .help = "start from this mesh file instead of the scene's own surface",
               .offers = Argument::Offers::files});
  command.add({.name = "--set",
               .target = &a->assignments,
               .help = "key=value; repeat for more (see 'multitracker scenes SCENE')",
               .list = Argument::List::words,
               .assigns = all_option_specs()});
  command.add({.name = "--steps", .target = &a->steps, .help = "number of steps, counted from the scene's start"});
  command.add({.name = "--seed", .target = &a->seed, .help = "seed of everything random"});
  command.add({.name = "--out",
               .target = &a->out,
               .help = "folder for run.json, metrics.csv, volumes.csv, events.csv and frames",
               .offers = Argument::Offers::folders});
  command.add({.name = "--force", .target = &a->force, .help = "replace a run that the folder holds"});
  command.add({.name = "--threads",
               .target = &a->threads,
               .help = "number of threads; 0: all cores; results do not depend on it"});
  command.add({.name = "--audit",
               .target = &a->audit,
               .help = "audit the surface after every step, and stop when it is not clean"});
  command.add({.name = "--quiet", .target = &a->quiet, .help = "print nothing but errors"});
  command.set_action([a, &program] { return run_scene(*a, program); });
}

}  // namespace multitracker::app
