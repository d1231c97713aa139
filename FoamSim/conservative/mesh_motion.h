#pragma once

#include <span>
#include <vector>

#include "FoamSim/conservative/film_shape.h"

namespace foamsim {

/// How the mesh goes along the films: what the fluxes leave free.
enum class Tangential {
  none,     ///< vertices keep to the films' normals; borders then sweep over their films' triangles
  air,      ///< with the mean of the air's velocities on both sides
  smoothed  ///< with the air, and towards the middle of the vertices around as fast as the triangles are deformed
};

/// The area-weighted mean of the triangles' values at every vertex, by vertex slot; 0 where there are no triangles.
void mean_at_vertices(const FilmConnectivity& films, const FilmShape& shape,
                      std::span<const lostopos::Vec3> of_triangles, std::vector<lostopos::Vec3>& of_vertices);

/// Adds to `tangential` (L/T, by vertex slot) at every vertex s (y − x): y is the middle of the triangles around it, at
/// a Plateau border that of the two neighbours along it, and s (1/T) the fastest rate at which an edge at the vertex
/// changes when all vertices move with `velocity` (L/T). So triangles that are pressed flat get room, at rest nothing
/// moves, and neither scale nor origin matters. Plateau vertices get nothing.
void add_smoothing(const FilmConnectivity& films, const FilmShape& shape, std::span<const lostopos::Vec3> positions,
                   std::span<const lostopos::Vec3> velocity, std::span<lostopos::Vec3> tangential);

}  // namespace foamsim
