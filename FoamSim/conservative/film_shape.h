#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "FoamSim/conservative/film_connectivity.h"
#include "LosTopos/vec3.h"

namespace foamsim {

/// The films at given positions.
struct FilmShape {
  std::vector<lostopos::Vec3> area_vector;      ///< N_t, by triangle, L²
  std::vector<double> area;                     ///< |N_t|
  std::vector<lostopos::Vec3> region_gradient;  ///< a_v^r = ∂V_r/∂x_v, by entry, L²
  /// By vertex slot: the damped pseudo-inverse of Σ_r a_v^r (a_v^r)ᵀ, L⁻⁴. With it the least squares of the scheme are
  /// P_r = a^r·(G⁺F) and u = G⁺ Σ_r a^r f^r. Zero where the vertex is held.
  std::vector<Eigen::Matrix3d> map;

  /// `positions` (L) by vertex slot. Same bits for any number of threads.
  void update(const FilmConnectivity& films, std::span<const lostopos::Vec3> positions);
};

/// A film's vertex sees one direction (the stacked a_v^r have one singular value that is not zero), a Plateau border's
/// two, a Plateau vertex's three; what is seen with less than this share of the best (films that nearly lie in one
/// plane, a film that is about to vanish) is damped, in the square of what is missing. Any symmetric map keeps forces
/// and velocities adjoint, so that energy stays right, and a vertex in such a place is not thrown along its border.
constexpr double weak_singular_value = 0.2;

/// x_c − x_b for corner k of triangle t, cyclic: the edge opposite.
inline lostopos::Vec3 opposite_edge(const FilmConnectivity& films, std::size_t t, std::size_t k,
                                    std::span<const lostopos::Vec3> positions) {
  return positions[films.corners[t][(k + 2) % 3]] - positions[films.corners[t][(k + 1) % 3]];
}

/// f_v^r of the triangles' potentials Ψ (L²/T), by entry: ½ (x_c − x_b)·Ψ_t at corner a of triangle t, with
/// both signs, L³/T. Overwrites `flux`.
void collect_fluxes(const FilmConnectivity& films, std::span<const lostopos::Vec3> positions,
                    std::span<const lostopos::Vec3> potential, std::vector<double>& flux);

/// The pressures P_v^r that balance a force at every vertex: least squares for Σ_r P_r a_v^r = F_v, by entry, force
/// over area. `force`: by vertex slot.
void balance(const FilmConnectivity& films, const FilmShape& shape, std::span<const lostopos::Vec3> force,
             std::span<double> pressure);

/// Σ_v (F_v − Σ_r P_v^r a_v^r)·u_v, L⁵/T³: energy that velocities put in against forces that pressures do not balance.
double unbalanced_power(const FilmConnectivity& films, const FilmShape& shape, std::span<const lostopos::Vec3> force,
                        std::span<const double> pressure, std::span<const lostopos::Vec3> velocity);

/// Velocities (L/T) that have a_v^r·u_v = f_v^r, by least squares, and otherwise are as near to `tangential` as can be;
/// 0 at held vertices. `flux`: by entry, L³/T.
void fit_velocities(const FilmConnectivity& films, const FilmShape& shape, std::span<const double> flux,
                    std::span<const lostopos::Vec3> tangential, std::span<lostopos::Vec3> velocity);

}  // namespace foamsim
