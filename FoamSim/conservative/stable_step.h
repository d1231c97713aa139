#pragma once

#include <span>

#include "FoamSim/conservative/film_shape.h"

namespace foamsim {

/// The longest step (T) that the stiffest vertex bears: 2/ω for the vertex that oscillates fastest when it alone moves,
/// over what neighbours that move against each other add. Its potential energy is `tension` (L³/T², energy of a film
/// over density and area) times the area, with the exact second derivative |opposite edge|²/(4 area) along the normal;
/// its kinetic energy is the regularised sum over the triangles around it. Infinite where nothing is stiff.
double stable_step(const FilmConnectivity& films, const FilmShape& shape, std::span<const lostopos::Vec3> positions,
                   double tension, double delta);

}  // namespace foamsim
