#pragma once

#include <optional>

#include "LosTopos/mesh/surface_mesh.h"

namespace foamsim {

/// Dihedral angles at Plateau borders (docs/method.md "The report's cases"): at every junction edge with three
/// triangles, the three angles between neighbouring half-planes.
struct JunctionAngles {
  std::optional<double> rms_deviation_deg;  ///< RMS of (angle − 120°) over all of them; empty without such edges
  std::optional<double> outer_mean_deg;  ///< mean of the angles between the two films that touch the air; empty without
  std::size_t edges = 0;                 ///< junction edges with three triangles
};

JunctionAngles junction_angles(const lostopos::SurfaceMesh& mesh);

}  // namespace foamsim
