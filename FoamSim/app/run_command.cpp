#include <cstdio>
#include <memory>

#include "Base/console/terminal.h"
#include "Base/error.h"
#include "Base/machine/memory.h"
#include "FoamSim/app/commands.h"
#include "FoamSim/app/scene_arguments.h"
#include "FoamSim/app/session.h"
#include "FoamSim/sheet/velocity/direct_kernel.h"

namespace foamsim::app {
namespace {

struct RunArguments {
  SceneArguments scene;
  std::string resume, simd;
};

void print_summary(const RunOutcome& outcome) {
  const Metrics& m = outcome.last;
  std::printf("%s after step %ld (time %g, dt %g): %zu triangles, area %.6g, energy %.6g, largest volume drift %.2e\n",
              std::string(name(outcome.end)).c_str(), m.step, m.time, outcome.dt, m.triangles, m.area, m.energy,
              m.volume_drift_max);
  if (m.angle_rms_deg) std::printf("junction angles: RMS deviation from 120 degrees %.3f", *m.angle_rms_deg);
  if (m.angle_rms_film_deg) std::printf(" (of the curved films %.3f)", *m.angle_rms_film_deg);
  if (m.angle_outer_mean_deg) std::printf(", mean outer angle %.3f degrees", *m.angle_outer_mean_deg);
  if (m.angle_rms_deg) std::printf("\n");
  if (!outcome.message.empty()) std::printf("%s\n", outcome.message.c_str());
  std::printf("output in %s, %.1f s\n", outcome.directory.c_str(), outcome.wall_seconds);
}

void print_stages(const RunOutcome& outcome) {
  const double total = outcome.times.total();
  const double steps = static_cast<double>(std::max(1L, outcome.last.step - outcome.first_step));
  std::printf("%-18s %10s %10s %7s\n", "stage", "seconds", "ms a step", "share");
  for (const auto& [stage, seconds] : outcome.times.stages())
    std::printf("%-18s %10.3f %10.3f %6.1f%%\n", stage.c_str(), seconds, 1e3 * seconds / steps, 100 * seconds / total);
}

void print_operation(const char* name, const lostopos::OperationCounts& counts) {
  std::printf("%-18s %10zu done, %.3f s; refused:", name, counts.done, counts.seconds);
  for (std::size_t k = 0; k < lostopos::refusal_count; ++k)
    if (counts.refused[k] > 0)
      std::printf(" %zu %s", counts.refused[k], lostopos::name(static_cast<lostopos::Refusal>(k)));
  std::printf("%s\n", counts.refused_in_all() == 0 ? " none" : "");
}

void print_tracker(const RunOutcome& outcome) {
  for (std::size_t i = 0; i < lostopos::operation_count; ++i)
    print_operation(lostopos::name(static_cast<lostopos::Operation>(i)), outcome.remesh.operations[i]);
  if (outcome.topology_enabled) {
    for (std::size_t i = 0; i < lostopos::topology_operation_count; ++i)
      print_operation(lostopos::name(static_cast<lostopos::TopologyOperation>(i)), outcome.topology.operations[i]);
    std::printf("%-18s %10zu cancelled; %zu vertices left where regions meet without a common film\n", "triangles",
                outcome.topology.cancelled_triangles, outcome.topology.incomplete_vertices);
  }
  const lostopos::MoveStatistics& m = outcome.move;
  std::printf("%-18s %10zu found, %zu proximities, %zu impulses, %zu inelastic and %zu rigid zones, %zu halved steps\n",
              "collisions", m.collisions, m.proximities, m.impulses, m.inelastic_zones, m.rigid_zones, m.halvings);
}

void print_active(const Scene& scene) {
  std::string effects;
  for (const std::string& effect : effects_of(scene.options)) effects += (effects.empty() ? "" : ", ") + effect;
  std::printf("scene %s; dynamics: %s; effects: %s\n", scene.name.c_str(), scene.options.word("dynamics").c_str(),
              effects.empty() ? "none" : effects.c_str());
  for (const base::OptionSpec& spec : scene.options.specs())
    if (scene.options.is_set(spec.key))
      std::printf("  %s = %s\n", spec.key.c_str(), base::to_text(spec, scene.options.value(spec.key)).c_str());
}

int exit_code_of(const RunOutcome& outcome) {
  if (outcome.end == RunEnd::interrupted) return InterruptGuard::exit_code();
  if (outcome.end == RunEnd::failed) return exit_cannot_go_on;
  return exit_done;
}

// The command that takes up a run where it was interrupted, to the same end.
std::string command_to_go_on(const Program& program, const SceneArguments& given, const RunOutcome& outcome) {
  std::string command = program.name + " run --resume " + outcome.checkpoint.string();
  if (given.steps) command += " --steps " + std::to_string(*given.steps);
  if (given.time) command += " --time " + base::to_text(*given.time);
  if (given.until_rest) command += " --until-rest";
  return command;
}

int run(const RunArguments& arguments, const Program& program) {
  const SceneArguments& given = arguments.scene;
  if (!arguments.simd.empty()) use_simd_target(arguments.simd);
  if (given.scene.empty() && arguments.resume.empty())
    throw base::InputError("run needs a scene (see 'foamsim scenes') or --resume FILE");
  const base::Ranks& ranks = *program.catalogue->sheet.ranks;
  RunSettings settings{given.out, given.force, arguments.resume, given.stop(), program.command_line, ranks.rank() == 0};
  const bool resuming = !arguments.resume.empty();
  if (resuming && (!given.scene.empty() || !given.assignments.empty() || !given.area.empty() || given.seed))
    throw base::InputError("--resume goes on with the scene of the checkpoint; leave out the scene and its options");
  const Scene scene = resuming ? built_in_scene("sphere", program.catalogue) : given.load(program);
  if (settings.out.empty() && !resuming) settings.out = std::filesystem::path("out") / scene.name;
  const ThreadLimit limit = thread_limit(given.threads);
  if (given.explain && !resuming) print_active(scene);
  const InterruptGuard guard;
  const RunOutcome outcome = [&] {
    Progress progress(resuming ? "resumed" : scene.name, given.quiet);
    RunHooks hooks = hooks_for(progress);
    hooks.interrupted = [&ranks] { return ranks.any(InterruptGuard::interrupted()); };
    hooks.large = base::give_back_large_blocks;
    // Several processes stop together, between steps.
    if (ranks.size() > 1) hooks.interrupted_within = {};
    return run_scene(scene, settings, hooks);
  }();
  if (outcome.end == RunEnd::failed) {
    base::print_error(program.name, "the simulation cannot go on: " + outcome.message);
    base::print_error(program.name, "the last good state is " + outcome.last_frame.string());
  }
  if (!given.quiet) print_summary(outcome);
  if (!given.quiet && outcome.end == RunEnd::interrupted)
    std::printf("to go on: %s\n", command_to_go_on(program, given, outcome).c_str());
  if (given.explain) {
    print_stages(outcome);
    print_tracker(outcome);
  }
  return exit_code_of(outcome);
}

}  // namespace

void add_run_command(base::Command& root, const Program& program) {
  base::Command& command = root.add_command("run", "simulate a scene");
  auto arguments = std::make_shared<RunArguments>();
  arguments->scene.add_to(command, program, true);
  command.add({.name = "--resume",
               .target = &arguments->resume,
               .help = "go on from this checkpoint.cbor",
               .offers = base::Argument::Offers::files});
  command.add({.name = "--simd",
               .target = &arguments->simd,
               .help = "instruction set of the sums; the best that the machine has unless given"});
  command.set_action([arguments, &program] { return run(*arguments, program); });
}

}  // namespace foamsim::app
