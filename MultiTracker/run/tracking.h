#pragma once

#include <vector>

#include "LosTopos/mesh/audit.h"
#include "LosTopos/run/motion.h"
#include "MultiTracker/run/checkpoint.h"

namespace multitracker {

/// A scene on its way, step by step.
class Tracking final : public lostopos::run::Motion {
 public:
  /// Starts on the given surface, or on the scene's own. Throws base::InputError for options out of range, or a surface
  /// beyond the option memory_limit. `interruption`: see TrackerOptions.
  explicit Tracking(Origin origin, const base::Interruption& interruption = {});
  /// Goes on from a checkpoint. Throws base::Error where its parts do not fit.
  explicit Tracking(Checkpoint checkpoint, const base::Interruption& interruption = {});
  /// From a checkpoint's file, or that of a run's folder. Throws base::FileError when it cannot be read, and
  /// base::InputError, naming it, for anything that is not a whole checkpoint of this version.
  static std::unique_ptr<Tracking> resumed(const std::filesystem::path& file,
                                           const base::Interruption& interruption = {});

  /// Throws what SurfaceTracker::step throws; the whole state is then the one before the step.
  void step() override;
  long steps() const override { return metrics_.step; }
  double time() const override { return metrics_.time; }
  const lostopos::SurfaceMesh& mesh() const override { return tracker_.mesh(); }
  const lostopos::run::StepWork& last() const override { return work_; }
  /// metrics.csv and volumes.csv (a row a region), each step, and events.csv.
  std::vector<lostopos::run::Table> tables() const override;
  /// The surface's measures at the start and now.
  void summarize(nlohmann::ordered_json& run) const override;
  bool resumable() const override { return true; }
  void save(nlohmann::json& checkpoint) const override;

  const lostopos::SurfaceTracker& tracker() const { return tracker_; }
  /// Of the last step; at the start: no motion, nothing done.
  const Metrics& metrics() const { return metrics_; }
  const Metrics& start() const { return start_; }
  const Origin& origin() const { return origin_; }
  double dt() const { return drive_.dt.of_step(metrics_.step); }  ///< of the next step, T
  /// With open ends allowed where the scene has them, or at the walls.
  lostopos::AuditReport audit() const;

 private:
  Tracking(Origin&& origin, lostopos::SurfaceMesh surface, const base::Interruption& interruption);
  void make_step();

  Origin origin_;
  Drive drive_;
  std::optional<lostopos::BoxWalls> walls_;
  bool ends_at_walls_;
  lostopos::SurfaceTracker tracker_;
  std::vector<lostopos::RegionVolume> start_volumes_;
  lostopos::run::StepWork work_;
  Metrics start_, metrics_;
  lostopos::SurfaceTracker::State before_;  // the step that is being made
};

}  // namespace multitracker
