#pragma once

#include <vector>

#include "LosTopos/mesh/surface_mesh.h"

namespace foamsim {

/// The vertices that `distance` edges, and no fewer, lead to from `start`, ascending.
std::vector<lostopos::Vertex> at_edge_distance(const lostopos::SurfaceMesh& mesh, lostopos::Vertex start, int distance);

}  // namespace foamsim
