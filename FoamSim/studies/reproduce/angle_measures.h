#pragma once

#include <filesystem>
#include <vector>

namespace foamsim {

/// What both angle measures find on a mesh whose vertices lie exactly on a standard double bubble, where every angle is
/// 120°: their own error.
struct MeasuredExactly {
  double volume_ratio;  ///< of the second bubble over the first
  long segments;        ///< edges around the border
  std::size_t triangles;
  double h_over_radius;                     ///< mean edge over the first bubble's radius
  double facets_rms_deg, facets_outer_deg;  ///< junction_angles
  double films_rms_deg, films_outer_deg;    ///< film_angles
};

/// For volumes 1:1 and 1:2 and the report's four resolutions as numbers of segments.
std::vector<MeasuredExactly> measure_exact_double_bubbles();

/// Slope of log film error over log h between two of them.
double film_order(const MeasuredExactly& coarse, const MeasuredExactly& fine);

/// Throws base::FileError.
void write_angle_measures(const std::filesystem::path& file, const std::vector<MeasuredExactly>& rows);

}  // namespace foamsim
