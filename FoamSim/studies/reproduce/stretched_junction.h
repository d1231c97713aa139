#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace foamsim {

/// The report's motivating experiment: three flat films that meet at 120°, and the triangles of the film between
/// regions 1 and 2 stretched within its plane.
struct StretchedJunctionRow {
  std::string area;                 ///< strategy
  double stretch;                   ///< of the rows of one film; 1: as the other two
  std::array<double, 3> curvature;  ///< H of regions 0, 1, 2 at the middle of the border, 1/L
  /// Largest difference between two regions' curvatures, 1/L: what drives the border although no angle has changed.
  double imbalance() const;
};

/// Every strategy with each stretch, φ = 0.5 and edges of length 1.
std::vector<StretchedJunctionRow> stretch_junction(const std::vector<double>& stretches = {1, 1.5, 2, 4});

/// One line a strategy, stretch and region. Throws base::FileError.
void write_stretched_junction(const std::filesystem::path& file, const std::vector<StretchedJunctionRow>& rows);

}  // namespace foamsim
