#include "MultiTracker/run/run.h"

#include <chrono>
#include <optional>

#include "Base/error.h"
#include "MultiTracker/run/run_files.h"

namespace multitracker {
namespace {

// Why the step could not be done, or what is wrong after it; empty when all is well.
std::string do_step(Tracking& tracking, bool audit) {
  const std::string where = "step " + std::to_string(tracking.metrics().step + 1) + ": ";
  try {
    tracking.step();
  } catch (const base::InputError&) {
    throw;
  } catch (const base::Error& error) {
    return where + error.what();
  }
  if (!audit) return {};
  const lostopos::AuditReport report = tracking.audit();
  return report.clean() ? std::string() : where + "the audit finds: " + report.text();
}

void add(RunOutcome& outcome, const Tracking& tracking) {
  outcome.last = tracking.metrics();
  outcome.topology += tracking.last().topology;
  outcome.topology.events.clear();  // they are in the file
  outcome.remesh += tracking.last().remesh;
}

}  // namespace

const char* name(RunEnd end) {
  switch (end) {
    case RunEnd::finished:
      return "finished";
    case RunEnd::interrupted:
      return "interrupted";
    case RunEnd::failed:
      return "failed";
  }
  return "unknown end";
}

RunOutcome run(Tracking& tracking, long steps, long frame_every, const RunSettings& settings, const RunHooks& hooks) {
  const auto begun = std::chrono::steady_clock::now();
  RunOutcome outcome;
  outcome.start = outcome.last = tracking.metrics();
  std::optional<RunFiles> files;
  if (!settings.out.empty()) {
    files.emplace(settings.out, settings.force);
    files->write_step(tracking);
    files->write_frame(tracking);
  }
  while (tracking.metrics().step < steps && outcome.end == RunEnd::finished) {
    if (hooks.interrupted && hooks.interrupted()) {
      outcome.end = RunEnd::interrupted;
      break;
    }
    const long before = tracking.metrics().step;
    outcome.message = do_step(tracking, settings.audit);
    if (!outcome.message.empty()) outcome.end = RunEnd::failed;
    if (tracking.metrics().step == before) break;
    add(outcome, tracking);
    const long step = tracking.metrics().step;
    if (files) files->write_step(tracking);
    if (files && frame_every > 0 && step % frame_every == 0) files->write_frame(tracking);
    if (hooks.progress) hooks.progress(outcome.last, static_cast<double>(step) / static_cast<double>(steps));
  }
  if (files) {
    files->write_frame(tracking);
    outcome.last_frame = files->last_frame();
  }
  outcome.wall_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
  return outcome;
}

}  // namespace multitracker
