#pragma once

#include <cstddef>
#include <vector>

#include "LosTopos/mesh/surface_mesh.h"

namespace lostopos {

struct EdgeTriangleContact {
  Edge edge;
  Triangle triangle;
};

/// All pairs of an edge and a triangle without a common vertex that meet (exact; touching counts), at most `limit` of
/// them, sorted by triangle, then edge. Candidates come from a sweep along the longest axis of the mesh.
std::vector<EdgeTriangleContact> edge_triangle_contacts(const SurfaceMesh& mesh, std::size_t limit);

}  // namespace lostopos
