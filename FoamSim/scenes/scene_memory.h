#pragma once

#include <optional>

#include "FoamSim/scenes/scene.h"

namespace foamsim {

/// How much a run of a scene takes, where users give the number of its bubbles.
struct SizeEstimate {
  double triangles = 0;  ///< at the start
  double bytes = 0;      ///< of the process, at its largest
};
std::optional<SizeEstimate> estimated_size(const Scene& scene);

/// Throws base::InputError, with both numbers, where the estimate is more than `available` bytes.
void require_memory(const SizeEstimate& size, double available);

}  // namespace foamsim
