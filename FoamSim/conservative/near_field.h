#pragma once

#include <span>
#include <vector>

#include "FoamSim/conservative/film_shape.h"

namespace foamsim {

/// What regularisation takes from the sheet at short distances, put back to first order in δ: it lowers the symbol of
/// the sheet's velocity from 1/(2k) to e^{−kδ}/(2k), an error of δ/2. The kinetic energy gains
///
///   (δ/4) (3/2 Σ_v A_v |c_v|² − 1/2 Σ_t A_t |d_t|²),   c_v = ⅓ Σ γ_t / A_v,  A_v = ⅓ Σ A_t,  d_t = ⅓ Σ c_v,
///
/// the first sum over the sheets (a vertex and one of its films, the inner sums over its triangles there), the second
/// over the triangles (the inner sum over their corners). With S for the mean over corners and back to triangles it is
/// (δ/4) ⟨γ, (S + ½ S (1 − S)) γ/A⟩. S has no eigenvalue above 1, so that the whole stays positive, and the highest
/// frequencies are not raised much, as they are without means. S alone is too weak for waves of ten edges (mode 3 of
/// 320 triangles is 3.7% slow), S + S (1 − S) too strong for longer ones (mode 2 is 2.1% fast): half of it is between.
/// A sliver counts for little. Vertices at a border, and next to one, have c_v = 0.
class NearField {
 public:
  NearField() = default;  ///< off
  /// `delta` (L) and `least_area` (L²), below which no A_v is taken to be, > 0.
  NearField(double delta, double least_area) : delta_(delta), least_area_(least_area) {}

  /// Adds its part ∂K/∂γ_t to the potentials of the triangles with strengths γ (L³/T).
  void add_potential(const FilmConnectivity& films, const FilmShape& shape, std::span<const lostopos::Vec3> strength,
                     std::span<lostopos::Vec3> potential);
  /// ∂K/∂A_t of its part at constant γ, for the strengths of the last call of add_potential; 0 where it is off.
  double area_slope(const FilmConnectivity& films, std::size_t t) const;

 private:
  void find_means(const FilmConnectivity& films, const FilmShape& shape, std::span<const lostopos::Vec3> strength);
  void find_means_of_means(const FilmConnectivity& films, const FilmShape& shape);

  double delta_ = 0, least_area_ = 0;
  std::vector<lostopos::Vec3> mean_, second_mean_;  // c_v, and ⅓ Σ A_t d_t / A_v, by sheet
  std::vector<lostopos::Vec3> smooth_;              // d_t
  std::vector<double> inverse_area_;                // 1 / A_v by sheet, 0 at and next to a border
};

}  // namespace foamsim
