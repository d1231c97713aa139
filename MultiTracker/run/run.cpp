#include "MultiTracker/run/run.h"

#include <nlohmann/json.hpp>

#include "Base/options/options_json.h"

namespace multitracker {
namespace {

lostopos::run::Output output_of(const RunSettings& settings, long frame_every) {
  lostopos::run::Output output;
  output.folder = settings.out;
  output.force = settings.force;
  output.frame_every = frame_every;
  const RunCall& call = settings.call;
  const nlohmann::ordered_json description = {{"version", call.version},
                                              {"command", call.command},
                                              {"scene", call.scene},
                                              {"mesh_file", call.mesh_file},
                                              {"options", base::options_to_json(call.options)}};
  output.describe = [description](nlohmann::ordered_json& run) { run.update(description); };
  return output;
}

std::string defect_of(const Tracking& tracking) {
  const lostopos::AuditReport report = tracking.audit();
  return report.clean() ? std::string() : "the audit finds: " + report.text();
}

}  // namespace

RunOutcome run(Tracking& tracking, long steps, long frame_every, const RunSettings& settings, const RunHooks& hooks) {
  lostopos::run::require_countable(static_cast<double>(steps), tracking.dt());
  lostopos::run::Plan plan{.last_step = steps};
  if (settings.audit) plan.defect = [&tracking] { return defect_of(tracking); };
  lostopos::run::Hooks own{.stepped = {}, .interrupted = hooks.interrupted};
  if (hooks.progress) own.stepped = [&](double fraction) { hooks.progress(tracking.metrics(), fraction); };
  lostopos::run::Outcome done = lostopos::run::run_motion(tracking, plan, output_of(settings, frame_every), own);
  return {.end = done.end,
          .message = std::move(done.message),
          .start = tracking.start(),
          .last = tracking.metrics(),
          .topology = std::move(done.work.topology),
          .remesh = done.work.remesh,
          .wall_seconds = done.wall_seconds,
          .last_frame = std::move(done.last_frame)};
}

}  // namespace multitracker
