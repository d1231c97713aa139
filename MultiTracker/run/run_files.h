#pragma once

#include <filesystem>

#include "Base/io/csv_table.h"
#include "MultiTracker/run/tracking.h"

namespace multitracker {

/// What a run writes into its folder: metrics.csv (a row a step), volumes.csv (step, time, region, volume, faces,
/// touches_air; a row a region and step), events.csv (step, time, kind, regions, position), and frames/*.ply.
class RunFiles {
 public:
  /// Makes the folder. Throws base::InputError when it holds a run already and `force` is false (with force that
  /// run is removed), base::FileError when it cannot be written.
  RunFiles(std::filesystem::path folder, bool force);

  /// Adds the rows of the step that has just been done.
  void write_step(const Tracking& tracking);
  /// Writes the surface as it is, unless it is the last that was written.
  void write_frame(const Tracking& tracking);

  const std::filesystem::path& folder() const { return folder_; }
  const std::filesystem::path& last_frame() const { return last_frame_; }

 private:
  std::filesystem::path folder_, last_frame_;
  base::CsvTable metrics_, volumes_, events_;
};

}  // namespace multitracker
