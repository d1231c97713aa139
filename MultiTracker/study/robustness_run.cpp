#include "MultiTracker/study/robustness_run.h"

#include <sys/resource.h>

#include <algorithm>
#include <memory>

#include "Base/error.h"
#include "Base/io/csv_table.h"
#include "Base/io/number_text.h"
#include "LosTopos/mesh/measures.h"
#include "LosTopos/topology/region_parts.h"
#include "MultiTracker/run/metrics_csv.h"
#include "MultiTracker/run/run.h"

namespace multitracker {
namespace {

namespace fs = std::filesystem;

constexpr const char* stopped = "stopped";

// What the processes took that have had a part in a run. Each adds a row before it ends.
struct Effort {
  double cpu_seconds = 0, peak_megabytes = 0;
};

fs::path effort_file(const RobustnessTask& task) {
  return task.folder / "processes.csv";
}
constexpr const char* effort_header = "cpu_seconds,peak_megabytes";

Effort earlier_effort(const RobustnessTask& task) {
  Effort sum;
  if (task.folder.empty() || !fs::exists(effort_file(task))) return sum;
  base::read_csv(effort_file(task), effort_header, [&](const std::vector<std::string>& cells) {
    sum.cpu_seconds += base::parse_double(cells[0]).value_or(0);
    sum.peak_megabytes = std::max(sum.peak_megabytes, base::parse_double(cells[1]).value_or(0));
  });
  return sum;
}

void note_own_effort(const RobustnessTask& task) {
  if (task.folder.empty()) return;
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  const double seconds = static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
                         1e-6 * static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
  std::string row;
  base::append_number(row, seconds);
  base::append_number(row += ",", static_cast<double>(usage.ru_maxrss) / 1024);
  base::CsvTable(effort_file(task), effort_header, true).add(row + "\n");
}

bool has_checkpoint(const RobustnessTask& task) {
  return !task.folder.empty() && fs::exists(task.folder / "checkpoint.cbor");
}

// The sum of a column of metrics.csv over all steps, those before a checkpoint included.
double sum_over_steps(const fs::path& folder, const std::string& column) {
  const auto columns = base::csv_cells_of(metrics_header());
  const auto place = static_cast<std::size_t>(std::ranges::find(columns, column) - columns.begin());
  double sum = 0;
  base::read_csv(folder / "metrics.csv", metrics_header(), [&](const std::vector<std::string>& cells) {
    sum += base::parse_double(cells.at(place)).value_or(0);
  });
  return sum;
}

RobustnessRun measured(const RobustnessTask& task, const Tracking& tracking, const RunOutcome& outcome) {
  const Metrics& m = tracking.metrics();
  RobustnessRun run{.key = task.key, .message = outcome.message};
  run.steps = static_cast<double>(m.step);
  run.shared_area = m.shared_area;
  run.air_area = m.air_area;
  run.air_pockets = static_cast<double>(m.air_pockets);
  run.triangles = static_cast<double>(m.triangles);
  run.junction_edges = static_cast<double>(m.junction_edges);
  run.incomplete_vertices = static_cast<double>(m.incomplete_vertices);
  if (task.folder.empty()) {
    run.snaps = static_cast<double>(outcome.topology[lostopos::TopologyOperation::snap].done);
    run.separations = static_cast<double>(outcome.topology[lostopos::TopologyOperation::separation].done);
  } else {
    run.snaps = sum_over_steps(task.folder, "snap_count");
    run.separations = sum_over_steps(task.folder, "t1_count");
  }
  return run;
}

// Where walls come to meet the air outside, pockets and tunnels of the size of a triangle are made all the time.
bool air_is_closed(const Tracking& tracking) {
  const lostopos::SurfaceMesh& mesh = tracking.mesh();
  const double edge = lostopos::mean_edge_length(mesh);
  return lostopos::surrounds_one_solid(mesh, lostopos::air, {.pocket = 0.5 * edge, .tunnel = 2 * edge});
}

void judge(const RobustnessTask& task, const Tracking& tracking, const RunOutcome& outcome, RobustnessRun& run) {
  run.verdict = Verdict::failed;
  if (outcome.end == RunEnd::failed) return;
  const lostopos::AuditReport report = tracking.audit();
  if (!report.clean()) {
    run.message = "the audit finds: " + report.text();
    return;
  }
  const bool closed = !task.until_closed || air_is_closed(tracking);
  run.verdict = closed ? Verdict::success : Verdict::open;
  if (!closed) {
    run.message = "voids are left after the last step: pockets ";
    base::append_number(run.message, static_cast<std::int64_t>(tracking.metrics().air_pockets));
    base::append_number(run.message += "; tunnels ", tracking.metrics().air_tunnels);
  }
}

}  // namespace

std::string make_robustness_run(const RobustnessTask& task, const std::function<bool()>& stop) {
  const Effort before = earlier_effort(task);
  const bool resuming = has_checkpoint(task);
  const base::Interruption interruption{stop};
  const auto tracking =
      resuming ? Tracking::resumed(task.folder, interruption)
               : std::make_unique<Tracking>(Origin{.scene = &scene_by_name("normal-flow"), .options = task.options},
                                            interruption);
  const auto closed = [&](const Metrics&) { return task.until_closed && air_is_closed(*tracking); };
  // One that was killed between its end and its row is not to go farther.
  const long last_step = closed(tracking->metrics()) ? tracking->metrics().step : task.options.whole("steps");
  const RunOutcome outcome = run(
      *tracking, last_step, {.out = task.folder, .force = !resuming, .go_on = resuming, .audit = task.audit_every_step},
      {.progress = {}, .interrupted = stop, .done = closed});
  note_own_effort(task);
  if (outcome.end == RunEnd::interrupted) return stopped;
  RobustnessRun run = measured(task, *tracking, outcome);
  judge(task, *tracking, outcome, run);
  run.cpu_seconds = before.cpu_seconds;
  run.peak_megabytes = before.peak_megabytes;
  return robustness_csv_row(run);
}

std::optional<RobustnessRun> read_result(const RobustnessTask& task, const ChildResult& child) {
  if (child.finished && child.text == stopped) return {};
  RobustnessRun run{.key = task.key, .verdict = child.late ? Verdict::late : Verdict::crashed, .message = child.text};
  if (child.finished) run = robustness_run_from(child.text);
  run.cpu_seconds += child.cpu_seconds;
  run.peak_megabytes = std::max(run.peak_megabytes, child.peak_megabytes);
  return run;
}

}  // namespace multitracker
