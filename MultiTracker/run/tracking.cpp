#include "MultiTracker/run/tracking.h"

#include "Base/timing/stopwatch.h"

namespace multitracker {

using lostopos::SurfaceMesh;

Tracking::Tracking(const SceneEntry& scene, const base::OptionSet& options, std::optional<SurfaceMesh> surface)
    : Tracking(scene, options, surface ? std::move(*surface) : scene.surface(options), 0) {}

Tracking::Tracking(const SceneEntry& scene, const base::OptionSet& options, SurfaceMesh surface, int)
    : closed_(scene.closed),
      drive_(scene.drive(options, surface)),
      tracker_(start_tracker(scene, options, std::move(surface))) {
  if (closed_) start_volumes_ = lostopos::region_volumes(mesh());
  metrics_ = measure(mesh(), last_, start_volumes_);
}

void Tracking::step() {
  const base::Stopwatch watch;
  const auto now = [this] { return FlowStep{mesh(), tracker_.held().slots(), metrics_.time, drive_.dt}; };
  const auto predicted = drive_.flow->predicted(now());
  const double flow_seconds = watch.seconds();
  last_ = tracker_.step(predicted, [&](lostopos::Vertex v) { return drive_.flow->still_moves(now(), v); });
  const long step = metrics_.step + 1;
  metrics_ = measure(mesh(), last_, start_volumes_);
  metrics_.step = step;
  metrics_.time = static_cast<double>(step) * drive_.dt;
  metrics_.flow_seconds = flow_seconds;
}

lostopos::AuditReport Tracking::audit() const {
  return lostopos::audit(mesh(), {.closed_regions = closed_});
}

}  // namespace multitracker
