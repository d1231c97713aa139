#pragma once

#include <set>

#include "FoamSim/sweep/started_run.h"

namespace foamsim::sweep {

struct SlurmSettings {
  Launcher launcher;              ///< what its tasks start runs with
  std::optional<int> at_a_time;   ///< tasks that run at the same time; none: as many as the queue lets
  std::string partition;          ///< empty: the default one
  std::vector<std::string> more;  ///< words for sbatch
};

/// Throws base::InputError where sbatch or squeue is not installed, or there is no such partition.
void require_slurm(const std::string& partition);

/// The runs that wait or go on in the queue. A submission of which the number was not recorded, because the program
/// ended in between, is looked for by its name: it is recorded when the queue has it, and forgotten when not (its runs,
/// if it made any, say so in their folders). Throws base::Error where the queue does not answer, so that it cannot be
/// known.
std::set<std::size_t> queued_runs(Sweep& sweep);

/// Shows in the states which runs are in the queue.
void mark_queued(const std::set<std::size_t>& queued, std::vector<RunState>& states);

/// Submits one array job with a task for each of the runs, and returns its number. That it will is written to
/// sweep.json before, the number after. Throws base::InputError where sbatch refuses it (nothing is recorded then),
/// base::Error where it cannot be known whether it was submitted.
std::string submit(Sweep& sweep, const std::vector<std::size_t>& runs, const SlurmSettings& settings);

/// "0-3,7": indices of an array job. The runs are in rising order.
std::string array_indices(const std::vector<std::size_t>& runs);

/// A word as a shell reads it back.
std::string shell_quoted(const std::string& word);

}  // namespace foamsim::sweep
