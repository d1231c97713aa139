#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "FoamSim/run/run.h"
#include "FoamSim/studies/reproduce/report_scene.h"

namespace foamsim {

/// One row of table1.csv: a double bubble brought to rest.
struct Table1Row {
  std::string area;
  long n = 0;  ///< subdivisions of each bubble
  long triangles_start = 0, triangles = 0;
  std::optional<double> angle_rms_deg;         ///< as the report defines it
  std::optional<double> angle_rms_film_deg;    ///< of the curved films (FilmAngles)
  std::optional<double> published_deg;         ///< the report's value; for `averaged` only
  std::optional<double> angle_outer_mean_deg;  ///< between the two facets towards the air
  std::optional<double> angle_outer_mean_film_deg;
  /// What an exact double bubble of the start volumes scores, with edges as long: the part of angle_rms_deg that flat
  /// facets make where every angle is 120°.
  double exact_facets_deg = 0;
  double border_height = 0;  ///< see mean_border_height, L
  double volume_drift_max = 0;
  double centroid_drift = 0;  ///< L
  long steps = 0;
  double time = 0;  ///< simulated, T
  double cpu_seconds = 0, wall_seconds = 0;
  std::string ended;  ///< RunEnd's name

  /// Own deviation less the published one, degrees.
  std::optional<double> difference_deg() const;
};

struct Table1Settings {
  std::vector<long> subdivisions{report_subdivisions.begin(), report_subdivisions.end()};
  /// `conservative`, which is not the report's, up to N = 48.
  std::vector<std::string> areas{"averaged", "constant-edge", "naive", "conservative"};
  /// Runs that are not at rest by this time end as they are, and the row says so. T.
  double longest_time = 12;
  std::filesystem::path out;  ///< gets table1.csv, and a folder for every run
  bool force = false;         ///< compute rows anew that `out` holds
  std::string command;
};

/// What the caller hears while a table is made.
struct Table1Hooks {
  /// A run begins: its hooks. `begin` and `end`: its share of the work that is left, from 0 to 1.
  std::function<RunHooks(const std::string& area, long n, double begin, double end)> run;
  std::function<void(const Table1Row&)> row;  ///< after each new row
};

/// Makes the table, coarse rows first. Rows that table1.csv holds already are kept; the file is whole after every row,
/// so that an interrupted table goes on where it stopped. Returns all rows, in the order of the settings; less when
/// interrupted. Throws like run_scene.
std::vector<Table1Row> make_table1(const Table1Settings& settings, const Table1Hooks& hooks = {});

/// Slope of log deviation over log (1/N) between two rows: the observed order of convergence. Empty without angles.
std::optional<double> observed_order(const Table1Row& coarse, const Table1Row& fine);

}  // namespace foamsim
