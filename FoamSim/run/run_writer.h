#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "Base/io/csv_table.h"
#include "FoamSim/metrics/metrics.h"
#include "FoamSim/run/run_directory.h"
#include "FoamSim/scenes/scene.h"
#include "LosTopos/io/pvd.h"

namespace foamsim {

/// Writes a run's files at the intervals that its scene asks for.
class RunWriter {
 public:
  /// Begins the tables; with `resumed_step` ≥ 0 goes on behind that step's rows. Throws base::FileError.
  RunWriter(RunDirectory directory, const Scene& scene, long resumed_step);

  /// The surface at the start: first frame and first rows.
  void write_start(const Simulation& simulation, const Metrics& metrics);
  /// What is due after a step.
  void write_step(const Scene& scene, const Simulation& simulation, const Metrics& metrics,
                  const std::vector<lostopos::RegionVolume>& start_volumes, const lostopos::Vec3& start_centroid);
  /// The present surface, unless it is the frame written last.
  void write_frame(const Simulation& simulation);
  void write_checkpoint(const Scene& scene, const Simulation& simulation,
                        const std::vector<lostopos::RegionVolume>& start_volumes, const lostopos::Vec3& start_centroid);

  const RunDirectory& directory() const { return directory_; }
  const std::filesystem::path& last_frame() const { return last_frame_; }

 private:
  void write_vtp(const Simulation& simulation);

  RunDirectory directory_;
  base::CsvTable metrics_, volumes_;
  std::optional<base::CsvTable> events_;  // only where the topology may change
  lostopos::PvdWriter pvd_;
  long frame_every_, metrics_every_, checkpoint_every_;
  bool vtp_;
  std::filesystem::path last_frame_;
};

}  // namespace foamsim
