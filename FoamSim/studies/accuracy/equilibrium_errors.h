#pragma once

#include <optional>

#include "LosTopos/mesh/surface_mesh.h"

namespace foamsim {

/// How far a surface of two bubbles is from the standard double bubble of the volumes that it has now: relative errors,
/// positive where the surface's value is too large. Those of a bubble are the mean of both.
struct EquilibriumErrors {
  double area = 0;      ///< of all films
  double radius = 0;    ///< of the sphere fitted to a bubble's outer film by least squares
  double rim = 0;       ///< mean distance of the Plateau border's vertices from their centre
  double wall = 0;      ///< area of the film between the bubbles
  double pressure = 0;  ///< from the mean curvature H of a bubble's outer film away from the border, against 2/r
  /// Deviation from 120° in degrees: of the facets (docs/method.md "The report's cases"), and of the films
  /// (FilmAngles).
  std::optional<double> angle_rms_deg, angle_rms_film_deg;
  std::optional<double> angle_outer_mean_deg;  ///< of the facets
};

/// Throws base::InputError unless regions 1 and 2 are the only bubbles, both with a film to the air and a Plateau
/// border between them.
EquilibriumErrors equilibrium_errors(const lostopos::SurfaceMesh& mesh);

}  // namespace foamsim
