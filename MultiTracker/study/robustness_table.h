#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace multitracker {

/// What became of a run of the study.
enum class Verdict {
  success,  ///< every step was done, and the audit is clean
  open,     ///< the same, but voids are left where the spheres were to close
  failed,   ///< a step could not be done, or the audit found something
  late,     ///< it used up its time
  crashed,  ///< its process ended by itself
};
/// "success", "open", ...
const char* name(Verdict verdict);

/// Which run it is.
struct RobustnessKey {
  long spheres = 0;
  double step = 0;  ///< as asked for, in mean edges
  long seed = 0;
  bool operator==(const RobustnessKey&) const = default;
};

/// One run, done in a process of its own.
struct RobustnessRun {
  RobustnessKey key;
  Verdict verdict = Verdict::crashed;
  std::string message = {};  ///< why it is no success
  double steps = 0, shared_area = 0, air_area = 0, air_pockets = 0, triangles = 0, junction_edges = 0;
  double incomplete_vertices = 0, snaps = 0, separations = 0;
  double cpu_seconds = 0, peak_megabytes = 0;  ///< sum and largest of all processes that had a part in it
  bool success() const { return verdict == Verdict::success; }
};

/// The runs of one number of spheres with one length of step.
struct RobustnessSummary {
  long spheres = 0;
  double step = 0;
  long runs = 0, successes = 0;
  double shared_area = 0, cpu_seconds = 0;  ///< means over the successes
  double peak_megabytes = 0;                ///< largest
};

/// In the order of the runs.
std::vector<RobustnessSummary> summarise(const std::vector<RobustnessRun>& runs);

/// One line with its newline.
std::string robustness_csv_row(const RobustnessRun& run);
/// Of such a line. Throws base::InputError for anything else.
RobustnessRun robustness_run_from(const std::string& row);

/// A row a run, all at once. Throws base::FileError, base::DiskError.
void write_robustness_table(const std::filesystem::path& file, const std::vector<RobustnessRun>& runs);
/// Throws base::InputError with file and line for what is no such table, base::FileError.
std::vector<RobustnessRun> read_robustness_table(const std::filesystem::path& file);

}  // namespace multitracker
