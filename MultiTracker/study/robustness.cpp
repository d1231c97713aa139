#include "MultiTracker/study/robustness.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "Base/error.h"
#include "Base/options/option_value.h"
#include "MultiTracker/run/run.h"
#include "MultiTracker/study/child_process.h"

namespace multitracker {

namespace {

base::OptionSet options_of_run(const RobustnessOptions& options, long spheres, double step, long seed) {
  base::OptionSet set = options_of(scene_by_name("normal-flow"));
  for (const std::string& assignment : options.assignments) set.set_assignment(assignment, "--set");
  set.set("spheres", spheres, "--spheres");
  // As many whole steps of about that length as make up the motion exactly.
  const long count = std::max(1L, std::lround(options.total_motion / step));
  set.set("step", options.total_motion / static_cast<double>(count), "--steps-of");
  set.set("seed", seed, "--seeds");
  set.set("layout", options.layout, "--layout");
  set.set("steps", count, "--steps-of");
  return set;
}

// In the child. The text is the figures, then the message.
std::string do_run(const base::OptionSet& options, bool audit_every_step) {
  Tracking tracking(Origin{.scene = &scene_by_name("normal-flow"), .options = options});
  RunOutcome outcome = run(tracking, options.whole("steps"), {.audit = audit_every_step});
  if (outcome.end == RunEnd::finished) {
    const lostopos::AuditReport report = tracking.audit();
    if (!report.clean()) {
      outcome.end = RunEnd::failed;
      outcome.message = "the audit finds: " + report.text();
    }
  }
  const Metrics& m = tracking.metrics();
  std::ostringstream text;
  text.precision(17);
  text << (outcome.end == RunEnd::finished) << ' ' << m.shared_area << ' ' << m.air_area << ' ' << m.triangles << ' '
       << m.junction_edges << ' ' << outcome.topology[lostopos::TopologyOperation::snap].done << ' '
       << outcome.topology[lostopos::TopologyOperation::separation].done << '\n'
       << outcome.message;
  return text.str();
}

RobustnessRun read(const ChildResult& child) {
  RobustnessRun run;
  run.cpu_seconds = child.cpu_seconds;
  run.peak_megabytes = child.peak_megabytes;
  run.message = child.text;
  if (!child.finished) return run;
  std::istringstream text(child.text);
  text >> run.success >> run.shared_area >> run.air_area >> run.triangles >> run.junction_edges >> run.snaps >>
      run.separations;
  std::getline(text, run.message);  // the rest of the line
  std::getline(text, run.message);
  return run;
}

}  // namespace

void check(const RobustnessOptions& options) {
  if (options.seeds < 1 || !(options.total_motion > 0) || !(options.time_limit > 0))
    throw base::InputError("a robustness study needs seeds >= 1, a total motion > 0 and a time limit > 0");
  for (double step : options.steps)
    if (!(step > 0 && step <= options.total_motion))
      throw base::InputError("--steps-of " + base::to_text(step) +
                             " is not allowed; a step has to be > 0 and at most the " + "total motion, " +
                             base::to_text(options.total_motion));
  for (long spheres : options.spheres)
    for (double step : options.steps) options_of_run(options, spheres, step, 1);
}

std::vector<RobustnessRun> run_robustness(const RobustnessOptions& options, const RobustnessHooks& hooks) {
  check(options);
  std::vector<RobustnessRun> runs;
  const std::size_t count = options.spheres.size() * options.steps.size() * static_cast<std::size_t>(options.seeds);
  for (long spheres : options.spheres)
    for (double step : options.steps)
      for (long seed = 1; seed <= options.seeds; ++seed) {
        if (hooks.interrupted && hooks.interrupted()) return runs;
        const base::OptionSet set = options_of_run(options, spheres, step, seed);
        const ChildResult child =
            run_in_child([&] { return do_run(set, options.audit_every_step); }, options.time_limit, hooks.interrupted);
        if (hooks.interrupted && hooks.interrupted()) return runs;
        RobustnessRun run = read(child);
        run.spheres = spheres;
        run.step = step;
        run.seed = seed;
        runs.push_back(run);
        if (hooks.done) hooks.done(run, static_cast<double>(runs.size()) / static_cast<double>(count));
      }
  return runs;
}

std::vector<RobustnessSummary> summarise(const std::vector<RobustnessRun>& runs) {
  std::vector<RobustnessSummary> summaries;
  for (const RobustnessRun& run : runs) {
    auto it = std::ranges::find_if(
        summaries, [&](const RobustnessSummary& s) { return s.spheres == run.spheres && s.step == run.step; });
    if (it == summaries.end()) it = summaries.insert(summaries.end(), {run.spheres, run.step});
    ++it->runs;
    it->peak_megabytes = std::max(it->peak_megabytes, run.peak_megabytes);
    if (!run.success) continue;
    ++it->successes;
    it->shared_area += run.shared_area;
    it->cpu_seconds += run.cpu_seconds;
  }
  for (RobustnessSummary& summary : summaries) {
    const double count = static_cast<double>(std::max(1L, summary.successes));
    summary.shared_area /= count;
    summary.cpu_seconds /= count;
  }
  return summaries;
}

std::string robustness_csv_header() {
  return "spheres,step,seed,success,shared_area,air_area,triangles,junction_edges,snap_count,t1_count,cpu_seconds,"
         "peak_megabytes,message";
}

std::string robustness_csv_row(const RobustnessRun& run) {
  std::string message = run.message.substr(0, run.message.find('\n'));
  std::ranges::replace(message, '"', '\'');
  std::string row;
  for (double value :
       {static_cast<double>(run.spheres), run.step, static_cast<double>(run.seed), run.success ? 1.0 : 0.0,
        run.shared_area, run.air_area, static_cast<double>(run.triangles), static_cast<double>(run.junction_edges),
        static_cast<double>(run.snaps), static_cast<double>(run.separations), run.cpu_seconds, run.peak_megabytes})
    row += base::to_text(value) + ",";
  return row + "\"" + message + "\"\n";
}

}  // namespace multitracker
