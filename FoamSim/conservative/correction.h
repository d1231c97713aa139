#pragma once

#include <span>
#include <vector>

#include "FoamSim/conservative/film_shape.h"

namespace foamsim {

/// What free films keep: energy (L⁵/T²), hydrodynamic impulse P = ∫ 2Γ n dA (L⁴/T) and angular impulse ∫ 2Γ x × n dA
/// (L⁵/T), x from a point that stays.
struct Invariants {
  double energy = 0;
  lostopos::Vec3 impulse = lostopos::Vec3::Zero(), angular_impulse = lostopos::Vec3::Zero();
};

/// The two impulses of potentials φ (by entry); energy is left at 0.
Invariants impulses(const FilmConnectivity& films, const FilmShape& shape, std::span<const lostopos::Vec3> positions,
                    const lostopos::Vec3& about, std::span<const double> phi);

/// Adds to `phi` the least change, in the mean square over the films' area, that changes the invariants by `wanted` to
/// first order: ∂P/∂φ_v^r = 2 a_v^r, ∂H/∂φ_v^r = −2 f_v^r. Nothing is changed at held vertices; with any of these only
/// the energy is corrected, as they take up impulse.
///
/// @param about the point of the angular impulse, L.
/// @param flux  f_v^r, by entry, L³/T.
/// @param phi   by entry, L²/T.
/// @return root mean square of the change over that of φ; 0 where nothing could be done (air at rest).
double correct_invariants(const FilmConnectivity& films, const FilmShape& shape,
                          std::span<const lostopos::Vec3> positions, const lostopos::Vec3& about,
                          std::span<const double> flux, const Invariants& wanted, std::span<double> phi);

}  // namespace foamsim
