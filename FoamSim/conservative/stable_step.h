#pragma once

#include <span>

#include "FoamSim/conservative/local_response.h"

namespace foamsim {

/// The longest step (T) that the fastest oscillation of the films, ẍ = −S H x, bears: 2/ω. H is the normal part of the
/// second derivative of `tension` (energy of a film over density and area, L³/T²) times area, S the air's response.
/// Infinite where nothing is stiff.
///
/// ω² is the largest eigenvalue of S H, by six rounds of Lanczos' method from a pattern without symmetry; as those and
/// the local response come from below, a fifth is added to ω.
double stable_step(const FilmConnectivity& films, const FilmShape& shape, std::span<const lostopos::Vec3> positions,
                   double tension, LocalResponse& response);

/// The longest time (T) in which no edge of a film changes by more than its length when its ends keep their velocities
/// (L/T, by vertex slot). Infinite where nothing moves.
double resolved_step(const FilmConnectivity& films, std::span<const lostopos::Vec3> positions,
                     std::span<const lostopos::Vec3> velocity);

}  // namespace foamsim
