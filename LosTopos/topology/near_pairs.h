#pragma once

#include <vector>

#include "LosTopos/collision/contact.h"
#include "LosTopos/remeshing/surface_index.h"

namespace lostopos {

/// Two elements without a common vertex, and the places on them that are nearest to each other.
struct NearPair {
  double distance = 0;  ///< L
  ElementPair pair;
  /// Of the points of contact in pair.vertices; not negative, of each element with sum 1.
  std::array<double, 4> weights = {};
};

/// How near the pair is now; weights as above.
NearPair measured(const SurfaceMesh& mesh, const ElementPair& pair);

/// All pairs (vertex, triangle) and (edge, edge) nearer than `distance` (L), nearest first, equals by handle. Runs in
/// parallel; the result does not depend on the number of threads, nor on `near` (see ContactSearch).
std::vector<NearPair> near_pairs(const SurfaceMesh& mesh, double distance, NearTriangles* near = nullptr);

/// Those of them that have an element of one of `triangles` (alive, each once); `index` holds the mesh.
std::vector<NearPair> near_pairs(const SurfaceMesh& mesh, SurfaceIndex& index, std::span<const Triangle> triangles,
                                 double distance);

}  // namespace lostopos
