#include "FoamSim/scenes/scene_memory.h"

#include <cmath>

#include "Base/error.h"
#include "Base/machine/memory.h"

namespace foamsim {

// Measured with foams of Voronoi cells from 100 to 5,000 bubbles (docs/scale.md): mesh, attributes, the searches'
// boxes, the tree of the sums and what a step keeps for the case that it fails.
std::optional<SizeEstimate> estimated_size(const Scene& scene) {
  constexpr double program = 20e6;
  const double of_triangle = scene.options.word("dynamics") == "conservative" ? 4200 : 2000;
  if (!scene.mesh_file.empty()) return std::nullopt;
  const auto& triangles = scene.catalogue->scenes.find(scene.name).triangles;
  if (!triangles) return std::nullopt;
  const double count = triangles(scene.options);
  return SizeEstimate{count, program + of_triangle * count};
}

void require_memory(const SizeEstimate& size, double available) {
  if (size.bytes <= available) return;
  throw base::InputError("so many bubbles are about " + base::to_text(std::round(size.triangles)) +
                         " triangles, which take " + base::bytes_in_words(size.bytes) + ", but " +
                         base::bytes_in_words(available) +
                         " of memory are left here; fewer bubbles, or a coarser resolution, would fit");
}

}  // namespace foamsim
