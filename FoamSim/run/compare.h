#pragma once

#include <string>
#include <vector>

#include "FoamSim/run/run.h"

namespace foamsim {

struct ComparedRun {
  std::string area;
  RunOutcome outcome;
};

/// One row of compare.csv.
struct ComparisonRow {
  std::string area, ended;
  long steps = 0;
  double time = 0;  ///< T
  long triangles = 0;
  std::optional<double> angle_outer_mean_deg, angle_rms_deg;
  double centroid_drift = 0;  ///< how far the area-weighted centre of the films has moved since the start, L
  double surface_area = 0;    ///< L²
  double energy = 0;          ///< L⁵/T²
  double volume_drift_max = 0;
  double seconds = 0;
  std::optional<double> angle_rms_film_deg;  ///< see FilmAngles
};
ComparisonRow summarise(const ComparedRun& run);

/// Reads compare.csv. Throws base::InputError when it is missing or malformed.
std::vector<ComparisonRow> read_comparison(const std::filesystem::path& file);

/// Runs the scene once with each area strategy, into `settings.out`/STRATEGY, and writes `settings.out`/compare.csv.
/// Stops early when a run is interrupted. `hooks_for` gives each run its hooks. Throws like run_scene.
std::vector<ComparedRun> compare_areas(const Scene& scene, const std::vector<std::string>& areas,
                                       const RunSettings& settings,
                                       const std::function<RunHooks(const std::string& area)>& hooks_for);

}  // namespace foamsim
