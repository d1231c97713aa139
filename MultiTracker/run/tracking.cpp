#include "MultiTracker/run/tracking.h"

#include <nlohmann/json.hpp>

#include "Base/timing/stopwatch.h"
#include "LosTopos/run/events_csv.h"
#include "LosTopos/run/proportion.h"
#include "MultiTracker/run/metrics_csv.h"

namespace multitracker {

using lostopos::SurfaceMesh;
using lostopos::run::Table;
using nlohmann::ordered_json;

namespace {

ordered_json state_json(const Metrics& m) {
  return {{"step", m.step},
          {"time", m.time},
          {"triangles", m.triangles},
          {"regions", m.regions},
          {"area", m.area},
          {"shared_area", m.shared_area},
          {"air_area", m.air_area},
          {"junction_edges", m.junction_edges},
          {"volume_drift_max", m.volume_drift_max}};
}

SurfaceMesh start_surface(const Origin& origin) {
  return origin.given ? SurfaceMesh::from_state(*origin.given) : own_surface(*origin.scene, origin.options);
}

}  // namespace

Tracking::Tracking(Origin origin, const base::Interruption& interruption)
    : Tracking(std::move(origin), start_surface(origin), interruption) {}

Tracking::Tracking(Origin&& origin, SurfaceMesh surface, const base::Interruption& interruption)
    : origin_(std::move(origin)),
      drive_(origin_.scene->drive(origin_.options, surface)),
      walls_(walls_of(*origin_.scene, surface, origin_.given.has_value())),
      ends_at_walls_(walls_ && lostopos::ends_at_walls(surface, *walls_)),
      tracker_(start_tracker(*origin_.scene, origin_.options, std::move(surface), walls_, interruption)) {
  if (origin_.scene->closed && !ends_at_walls_) start_volumes_ = lostopos::region_volumes(mesh());
  start_ = metrics_ = measure(mesh(), {}, start_volumes_);
}

Tracking::Tracking(Checkpoint checkpoint, const base::Interruption& interruption)
    : Tracking(std::move(checkpoint.origin), interruption) {
  tracker_.restore(checkpoint.surface);
  lostopos::run::require_proportion(mesh(), tracker_.options().resolution, tracker_.options().remeshing);
  start_volumes_ = std::move(checkpoint.start_volumes);
  start_ = checkpoint.start;
  metrics_ = measure(mesh(), {}, start_volumes_);
  metrics_.step = checkpoint.step;
  metrics_.time = drive_.dt.time_of(checkpoint.step);
}

std::unique_ptr<Tracking> Tracking::resumed(const std::filesystem::path& file, const base::Interruption& interruption) {
  std::unique_ptr<Tracking> tracking;
  lostopos::run::read_checkpoint(std::filesystem::is_directory(file) ? file / "checkpoint.cbor" : file,
                                 checkpoint_format(), [&](const nlohmann::json& content) {
                                   tracking = std::make_unique<Tracking>(checkpoint_from(content), interruption);
                                 });
  return tracking;
}

void Tracking::step() {
  tracker_.save(before_);
  try {
    make_step();
  } catch (...) {
    tracker_.restore(before_);
    throw;
  }
}

void Tracking::make_step() {
  const base::Stopwatch watch;
  const auto now = [this] { return FlowStep{mesh(), tracker_.held().slots(), metrics_.time, dt()}; };
  const auto predicted = drive_.flow->predicted(now());
  const double flow_seconds = watch.seconds();
  lostopos::TrackerStep done =
      tracker_.step(predicted, [&](lostopos::Vertex v) { return drive_.flow->still_moves(now(), v); });
  if (ends_at_walls_) keep_to_walls(*origin_.scene, *walls_, tracker_);
  const long step = metrics_.step + 1;
  metrics_ = measure(mesh(), done, start_volumes_);
  metrics_.step = step;
  metrics_.time = drive_.dt.time_of(step);
  metrics_.flow_seconds = flow_seconds;
  work_ = {{}, done.move.statistics, std::move(done.topology), done.remesh};
  work_.times.add("flow", flow_seconds);
  work_.times.add("move", done.move_seconds);
  work_.times.add("topology", done.topology_seconds);
  work_.times.add("remesh", done.remesh_seconds);
}

std::vector<Table> Tracking::tables() const {
  return {{"metrics.csv", metrics_header(), 1, [this] { return metrics_row(metrics_); }},
          {"volumes.csv", volumes_header(), 1, [this] { return volumes_rows(metrics_, mesh()); }},
          lostopos::run::events_table(*this)};
}

void Tracking::summarize(ordered_json& run) const {
  run["start"] = state_json(start_);
  run["last"] = state_json(metrics_);
}

void Tracking::save(nlohmann::json& checkpoint) const {
  checkpoint = checkpoint_content({origin_, tracker_.state(), metrics_.step, start_, start_volumes_});
}

lostopos::AuditReport Tracking::audit() const {
  lostopos::AuditOptions options{.closed_regions = origin_.scene->closed};
  if (ends_at_walls_) options.walls = walls_;
  return lostopos::audit(mesh(), options);
}

}  // namespace multitracker
