#pragma once

#include <optional>

#include "LosTopos/mesh/surface_mesh.h"

namespace foamsim {

/// Angles between the films themselves at Plateau borders, not between the flat facets that stand for them.
struct FilmAngles {
  std::optional<double> rms_deviation_deg;  ///< RMS of (angle − 120°), degrees; empty without such vertices
  std::optional<double> outer_mean_deg;     ///< mean of the angles on the air's side, degrees
  std::size_t vertices = 0;                 ///< where angles were measured
};

/// At every vertex where exactly two junction edges of three triangles each meet: the angles about the border's tangent
/// (of the parabola through the vertex and its two neighbours on the border) between the tangent planes of the three
/// films. A film's tangent plane is that of a quadratic height function through the vertex, fitted by weighted least
/// squares to the film's vertices in the neighbourhood (two rings, more where these hold few).
///
/// A facet leaves the border at another angle than the curved film it spans, by half the facet's height over the film's
/// radius, so that `junction_angles` is off by O(h) on a surface that is sampled exactly; this measure is off by O(h²),
/// and on spheres by O(h³).
FilmAngles film_angles(const lostopos::SurfaceMesh& mesh);

}  // namespace foamsim
