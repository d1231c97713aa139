#pragma once

#include "FoamSim/sweep/grid.h"

namespace foamsim::sweep {

/// One run of a sweep.
struct PlannedRun {
  std::string name;                 ///< of its folder: "n=8_area=naive"; it tells the values
  std::vector<std::string> values;  ///< one an axis
  bool operator==(const PlannedRun&) const = default;
};

/// The most that one sweep can have.
inline constexpr std::size_t most_runs = 100'000;

/// The run with these values, one an axis. Its name has letters, digits and =.+-_ only; where that loses something, or
/// it would be long, it ends in a hash of the values.
PlannedRun planned_run(const Grid& grid, std::vector<std::string> values);

/// All combinations, the last axis fastest. Throws base::InputError for more than most_runs.
std::vector<PlannedRun> plan_runs(const Grid& grid);

/// The table that a run writes: metrics.csv, or that of the study.
std::string table_of_run(const Grid& grid);

/// What `foamsim` is called with for a run, without where its output goes.
std::vector<std::string> run_arguments(const Grid& grid, const PlannedRun& run);
/// What says how far it runs, also when it is resumed.
std::vector<std::string> stop_arguments(const Grid& grid);

/// Checks that the options of every run go together. Throws base::InputError that names the run.
void require_valid(const Grid& grid, const std::vector<PlannedRun>& runs, std::shared_ptr<const Catalogue> catalogue);

}  // namespace foamsim::sweep
