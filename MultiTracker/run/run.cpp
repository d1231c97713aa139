#include "MultiTracker/run/run.h"

#include <nlohmann/json.hpp>

#include "Base/options/options_json.h"

namespace multitracker {
namespace {

lostopos::run::Output output_of(const Tracking& tracking, const RunSettings& settings) {
  const Origin& origin = tracking.origin();
  lostopos::run::Output output;
  output.folder = settings.out;
  output.force = settings.force;
  output.go_on = settings.go_on;
  output.frame_every = origin.options.whole("frame_every");
  output.checkpoint_every = origin.options.whole("checkpoint_every");
  output.checkpoint_seconds = origin.options.number("checkpoint_seconds");
  output.rec_every = origin.options.whole("rec_every");
  output.obj_every = origin.options.whole("obj_every");
  output.rec_flavour = lostopos::RecFlavour::Tracker;
  output.checkpoint = checkpoint_format();
  const nlohmann::ordered_json description = {{"version", settings.call.version},
                                              {"command", settings.call.command},
                                              {"scene", origin.scene->name},
                                              {"mesh_file", origin.mesh_file},
                                              {"options", base::options_to_json(origin.options)}};
  output.describe = [description](nlohmann::ordered_json& run) { run.update(description); };
  return output;
}

std::string defect_of(const Tracking& tracking) {
  const lostopos::AuditReport report = tracking.audit();
  return report.clean() ? std::string() : "the audit finds: " + report.text();
}

}  // namespace

RunOutcome run(Tracking& tracking, long last_step, const RunSettings& settings, const RunHooks& hooks) {
  lostopos::run::require_countable(static_cast<double>(last_step), tracking.dt());
  lostopos::run::Plan plan{.last_step = last_step};
  if (settings.audit) plan.defect = [&tracking] { return defect_of(tracking); };
  if (hooks.done) plan.stop = [&] { return hooks.done(tracking.metrics()); };
  lostopos::run::Hooks own{.stepped = {}, .interrupted = hooks.interrupted};
  if (hooks.progress) own.stepped = [&](double fraction) { hooks.progress(tracking.metrics(), fraction); };
  lostopos::run::Outcome done = lostopos::run::run_motion(tracking, plan, output_of(tracking, settings), own);
  return {.end = done.end,
          .message = std::move(done.message),
          .start = tracking.start(),
          .last = tracking.metrics(),
          .topology = std::move(done.work.topology),
          .remesh = done.work.remesh,
          .wall_seconds = done.wall_seconds,
          .last_frame = std::move(done.last_frame),
          .checkpoint = std::move(done.checkpoint)};
}

}  // namespace multitracker
