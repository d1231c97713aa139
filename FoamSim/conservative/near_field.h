#pragma once

#include <span>
#include <vector>

#include "FoamSim/conservative/film_shape.h"

namespace foamsim {

/// What regularisation takes from the sheet at short distances, put back to first order in δ: it lowers the symbol of
/// the sheet's velocity from 1/(2k) to e^{−kδ}/(2k), an error of δ/2. The kinetic energy gains
///
///   (δ/4) Σ |g|² / max(A, least_area),   g = ⅓ Σ γ_t,  A = ⅓ Σ A_t,
///
/// a sum over the sheets (a vertex and one of its films) and in each over its triangles: positive, so that the whole
/// stays so. Means around a vertex, unlike single triangles, do not raise the highest frequencies much, and a sliver
/// counts for little in them.
class NearField {
 public:
  NearField() = default;  ///< off
  /// `delta` (L) and `least_area` (L²) > 0.
  NearField(double delta, double least_area) : delta_(delta), least_area_(least_area) {}

  /// Adds its part ∂K/∂γ_t to the potentials of the triangles with strengths γ (L³/T).
  void add_potential(const FilmConnectivity& films, const FilmShape& shape, std::span<const lostopos::Vec3> strength,
                     std::span<lostopos::Vec3> potential);
  /// ∂K/∂A_t of its part at constant γ, for the strengths of the last call of add_potential; 0 where it is off.
  double area_slope(const FilmConnectivity& films, std::size_t t) const;

 private:
  double delta_ = 0, least_area_ = 0;
  std::vector<lostopos::Vec3> mean_;  // g / A by sheet
  std::vector<double> slope_;         // −|g|² / A² by sheet, 0 below the least area
};

}  // namespace foamsim
