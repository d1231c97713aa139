#pragma once

#include <optional>

#include "FoamSim/scenes/scene.h"
#include "LosTopos/memory_limit.h"

namespace foamsim {

/// Memory of the process for each triangle of a scene's surface, with the dynamics that it has.
double bytes_of_triangle(const base::OptionSet& options);

/// How much a run of a scene takes at its start, of what its options say of sizes; none where the surface comes from a
/// file.
std::optional<lostopos::SizeEstimate> estimated_size(const Scene& scene);

/// How much it takes once its films are remeshed to the edges `resolution` (L); 0: as they are.
lostopos::SizeEstimate estimated_size(const base::OptionSet& options, const lostopos::SurfaceMesh& surface,
                                      double resolution);

}  // namespace foamsim
