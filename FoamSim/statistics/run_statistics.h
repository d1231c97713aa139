#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "FoamSim/statistics/statistics_tables.h"

namespace foamsim {

/// What to count of a run, and where to write it.
struct RunStatisticsOptions {
  std::filesystem::path run;      ///< its folder
  std::optional<long> step = {};  ///< of one frame alone
  std::filesystem::path out;      ///< folder for the tables
  /// Called after each frame, with what is done of all.
  std::function<void(const FrameStatistics&, double fraction)> counted = {};
  std::function<bool()> interrupted = {};  ///< asked before each frame
};

/// Reads the frames of a run and writes foam.csv, bubbles.csv, films.csv and distributions.csv, each whole or not at
/// all. Returns the statistics of the last frame. Throws base::InputError where the folder is none of a run, or frames
/// are missing or damaged; base::Interrupted, with nothing written; base::FileError, base::DiskError.
FrameStatistics write_run_statistics(const RunStatisticsOptions& options);

}  // namespace foamsim
