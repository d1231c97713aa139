#pragma once

#include <filesystem>

#include "FoamSim/sweep/plan.h"

namespace foamsim::sweep {

/// An array job that was, or was about to be, submitted.
struct Submission {
  std::string job_name;  ///< known before it is submitted, and to no other submission
  std::string job;       ///< Slurm's number; empty: not known whether it was submitted
  bool operator==(const Submission&) const = default;
};

/// A sweep and its folder: sweep.json (grid, runs, submissions), runs/NAME/ and table.csv.
struct Sweep {
  std::filesystem::path folder;  ///< absolute
  Grid grid;
  std::vector<PlannedRun> runs;
  std::vector<Submission> submissions = {};

  std::filesystem::path record() const { return folder / "sweep.json"; }
  std::filesystem::path table() const { return folder / "table.csv"; }
  std::filesystem::path run_folder(std::size_t run) const { return folder / "runs" / runs[run].name; }
};

/// The sweep of this grid in a folder: one that is there already goes on. Nothing is written. Throws base::InputError
/// where the folder holds something else: another grid's sweep, or a run.
Sweep sweep_in(const std::filesystem::path& folder, Grid grid);
/// The same with the runs given, where not every combination is one.
Sweep sweep_in(const std::filesystem::path& folder, Grid grid, std::vector<PlannedRun> runs);
/// The sweep that a folder holds. Throws base::InputError where there is none.
Sweep read_sweep(const std::filesystem::path& folder);
/// Makes the folder and writes sweep.json, whole or not at all. Throws base::FileError.
void write_sweep(const Sweep& sweep);

}  // namespace foamsim::sweep
