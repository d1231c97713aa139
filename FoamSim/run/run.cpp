#include "FoamSim/run/run.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "Base/error.h"
#include "Base/interruption.h"
#include "Base/machine/memory.h"
#include "Base/options/options_json.h"
#include "FoamSim/run/scene_motion.h"
#include "FoamSim/run/start_checks.h"
#include "FoamSim/scenes/scene_memory.h"
#include "FoamSim/version.h"

namespace foamsim {

using lostopos::run::Plan;
using nlohmann::ordered_json;

namespace {

std::filesystem::path checkpoint_file(const std::filesystem::path& given) {
  return std::filesystem::is_directory(given) ? given / "checkpoint.cbor" : given;
}

long last_step(const StopAt& stop, const SceneMotion& motion) {
  const double dt = motion.simulation().options().dt;
  if (stop.steps) lostopos::run::require_countable(static_cast<double>(*stop.steps), dt);
  auto steps_of = [dt](double time) { return lostopos::run::steps_of(time, dt); };
  if (stop.steps && stop.time) return std::min(*stop.steps, steps_of(*stop.time));
  if (stop.steps) return *stop.steps;
  if (stop.time) return steps_of(*stop.time);
  const base::OptionSet& options = motion.scene().options;
  if (stop.until_rest) {
    const double characteristic = characteristic_time(motion.start().volumes, options.number("sigma"));
    if (!(characteristic > 0))
      throw base::InputError(
          "--until-rest needs a bubble and a tension (sigma > 0), whose characteristic time tells what rest is; give "
          "--time or --steps here");
    return steps_of(rest_patience * characteristic);
  }
  return steps_of(options.number("time"));
}

bool same_folder(const std::filesystem::path& a, const std::filesystem::path& b) {
  return std::filesystem::weakly_canonical(a) == std::filesystem::weakly_canonical(b);
}

lostopos::run::Output output_of(const SceneMotion& motion, const RunSettings& settings,
                                const std::filesystem::path& checkpoint) {
  const Scene& scene = motion.scene();
  const auto folder_of_checkpoint = checkpoint.parent_path().empty() ? "." : checkpoint.parent_path();
  const auto folder = settings.out.empty() ? folder_of_checkpoint : settings.out;
  const nlohmann::ordered_json description = {{"version", version},
                                              {"command", settings.command},
                                              {"scene", scene.name},
                                              {"mesh_file", scene.mesh_file},
                                              {"dt", motion.simulation().options().dt},
                                              {"options", base::options_to_json(options_in_use(scene.options))},
                                              {"seed", scene.options.whole("seed")}};
  return {.folder = folder,
          .force = settings.force,
          .go_on = !checkpoint.empty() && same_folder(folder, folder_of_checkpoint),
          .frame_every = scene.options.whole("frame_every"),
          .checkpoint_every = scene.options.whole("checkpoint_every"),
          .checkpoint_seconds = scene.options.number("checkpoint_seconds"),
          .vtp = options_in_use(scene.options).flag("vtp"),
          .rec_every = scene.options.whole("rec_every"),
          .obj_every = scene.options.whole("obj_every"),
          .reference_frames = 2,
          .checkpoint = checkpoint_format(),
          .describe = [description](nlohmann::ordered_json& run) { run.update(description); }};
}

RunOutcome outcome_of(const SceneMotion& motion, lostopos::run::Outcome&& done, const std::filesystem::path& folder) {
  RunOutcome outcome;
  outcome.end = done.end;
  outcome.message = std::move(done.message);
  outcome.first_step = done.first_step;
  outcome.dt = motion.simulation().options().dt;
  outcome.last = motion.metrics();
  outcome.start_centroid = motion.start().centroid;
  outcome.times = std::move(done.work.times);
  outcome.remesh = done.work.remesh;
  outcome.move = done.work.move;
  outcome.topology_enabled = motion.simulation().options().tracker.topology.enabled;
  outcome.topology = std::move(done.work.topology);
  outcome.wall_seconds = done.wall_seconds;
  outcome.directory = folder;
  outcome.last_frame = std::move(done.last_frame);
  outcome.checkpoint = std::move(done.checkpoint);
  return outcome;
}

}  // namespace

namespace {

void note_size(const lostopos::SizeEstimate& size, const base::OptionSet& options, const RunHooks& hooks) {
  constexpr double share_of_limit = 0.5;
  if (hooks.large && size.bytes > share_of_limit * lostopos::memory_limit(options)) hooks.large();
}

// What a user should know of a large scene before it is built.
void look_at_size(const Scene& scene, const RunHooks& hooks) {
  constexpr double worth_a_word = 2e8;
  const std::optional<lostopos::SizeEstimate> size = estimated_size(scene);
  if (!size) return;
  lostopos::require_memory(*size, lostopos::memory_limit(scene.options));
  if (size->bytes > worth_a_word && hooks.warn)
    hooks.warn("about " + base::to_text(std::round(size->triangles)) + " triangles, which take " +
               base::bytes_in_words(size->bytes) + " of memory");
  note_size(*size, scene.options, hooks);
}

lostopos::SizeEstimate size_of(const SceneMotion& motion) {
  const Simulation& simulation = motion.simulation();
  return estimated_size(motion.scene().options, simulation.mesh(), simulation.options().resolution);
}

}  // namespace

RunOutcome run_scene(const Scene& scene, const RunSettings& settings, const RunHooks& hooks) {
  const bool resuming = !settings.resume.empty();
  const auto checkpoint = resuming ? checkpoint_file(settings.resume) : std::filesystem::path();
  if (!resuming) look_at_size(scene, hooks);
  // A start that is relaxed by half is none to go on from.
  const auto relaxing = [&hooks](long done, long of) {
    if (hooks.relaxed) hooks.relaxed(done, of);
    base::Interruption{hooks.interrupted}.check();
    return true;
  };
  const base::Interruption within{hooks.interrupted_within};
  SceneMotion motion(resuming ? SceneMotion::beginning_of(checkpoint, scene.catalogue, within)
                              : SceneMotion::beginning_of(scene, relaxing, within));
  const std::vector<std::string> notes =
      resuming ? check_surface(motion.simulation()) : check_start(scene, motion.simulation(), motion.start());
  for (const std::string& note : notes)
    if (hooks.warn) hooks.warn(note);
  note_size(size_of(motion), motion.scene().options, hooks);
  Plan plan{.last_step = last_step(settings.stop, motion)};
  if (settings.stop.until_rest) plan.at_rest = [&motion] { return motion.at_rest(); };
  const lostopos::run::Output output =
      settings.write ? output_of(motion, settings, checkpoint) : lostopos::run::Output();
  const Metrics start = motion.metrics();
  lostopos::run::Hooks own{.stepped = {}, .interrupted = hooks.interrupted};
  if (hooks.progress) own.stepped = [&](double done) { hooks.progress(motion.steps(), motion.time(), done); };
  RunOutcome outcome = outcome_of(motion, lostopos::run::run_motion(motion, plan, output, own), output.folder);
  outcome.start = start;
  return outcome;
}

}  // namespace foamsim
