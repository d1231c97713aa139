#include "FoamSim/scenes/scene_memory.h"

#include <algorithm>

#include "LosTopos/mesh/measures.h"
#include "LosTopos/tracker_options.h"

namespace foamsim {
namespace {

lostopos::SizeEstimate size_of(const base::OptionSet& options, double triangles) {
  return {triangles, lostopos::bytes_of_program + bytes_of_triangle(options) * triangles};
}

}  // namespace

// Measured with foams of Voronoi cells from 100 to 5,000 bubbles (docs/scale.md): the tracker's, and the tree of the
// sums; or the systems of the conservative dynamics.
double bytes_of_triangle(const base::OptionSet& options) {
  return options.word("dynamics") == "conservative" ? 6200 : lostopos::default_bytes_of_triangle;
}

std::optional<lostopos::SizeEstimate> estimated_size(const Scene& scene) {
  if (!scene.mesh_file.empty()) return std::nullopt;
  const auto& triangles = scene.catalogue->scenes.find(scene.name).triangles;
  if (!triangles) return std::nullopt;
  return size_of(scene.options, triangles(scene.options));
}

lostopos::SizeEstimate estimated_size(const base::OptionSet& options, const lostopos::SurfaceMesh& surface,
                                      double resolution) {
  const auto there = static_cast<double>(surface.triangle_count());
  const bool refined = options.flag("remeshing.enabled") && resolution > 0;
  const double wanted = refined ? lostopos::triangles_on(lostopos::total_area(surface), resolution) : 0;
  return size_of(options, std::max(there, wanted));
}

}  // namespace foamsim
