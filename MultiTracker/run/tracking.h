#pragma once

#include <optional>
#include <string>
#include <vector>

#include "LosTopos/mesh/audit.h"
#include "MultiTracker/run/metrics.h"
#include "MultiTracker/scenes/scene.h"

namespace multitracker {

/// A scene on its way, step by step, in memory.
class Tracking {
 public:
  /// Starts on `surface`, or on the scene's own. Throws base::InputError for options out of range.
  Tracking(const SceneEntry& scene, const base::OptionSet& options,
           std::optional<lostopos::SurfaceMesh> surface = std::nullopt);

  /// Throws what SurfaceTracker::step throws; the surface is then as the last part of a step that could be done left
  /// it.
  void step();

  const lostopos::SurfaceTracker& tracker() const { return tracker_; }
  const lostopos::SurfaceMesh& mesh() const { return tracker_.mesh(); }
  /// Of the last step; at the start: no motion, nothing done.
  const Metrics& metrics() const { return metrics_; }
  const lostopos::TrackerStep& last() const { return last_; }
  double dt() const { return drive_.dt; }
  /// With open ends allowed where the scene has them.
  lostopos::AuditReport audit() const;

 private:
  Tracking(const SceneEntry& scene, const base::OptionSet& options, lostopos::SurfaceMesh surface, int);

  bool closed_;
  Drive drive_;
  lostopos::SurfaceTracker tracker_;
  std::vector<lostopos::RegionVolume> start_volumes_;
  lostopos::TrackerStep last_;
  Metrics metrics_;
};

}  // namespace multitracker
