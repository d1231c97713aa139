#pragma once

#include <span>

#include "LosTopos/mesh/surface_mesh.h"

namespace lostopos {

/// A part of a sphere, or a disc, that ends at a circle in the plane x = 0 about the x axis.
struct CircleFilm {
  double polar_angle;  ///< from the pole to the circle, radians, in (−π, π); > 0: the pole lies at x > 0; 0: a disc
  Labels labels;       ///< at the pole: p towards −x, q towards +x
};

/// Films that share a circle of radius `rim_radius` (L, > 0), for shapes known in closed form: every vertex lies on its
/// film exactly. `segments` edges around the circle, ≥ 6; the other edges are about as long. Throws InputError for
/// values out of range.
SurfaceMesh films_on_circle(double rim_radius, std::span<const CircleFilm> films, long segments);

}  // namespace lostopos
