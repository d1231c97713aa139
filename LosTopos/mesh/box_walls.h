#pragma once

#include "LosTopos/mesh/hold.h"
#include "LosTopos/mesh/surface_mesh.h"

namespace lostopos {

/// Lets the vertices on the walls of the box from `low` to `high` slide: each holds the coordinates in which it is at
/// either to the bit, in addition to what it holds already.
inline void hold_in_box_walls(const SurfaceMesh& mesh, VertexAttribute<Hold>& held, const Vec3& low, const Vec3& high) {
  for (Vertex v : mesh.vertices()) {
    const Vec3& x = mesh.position(v);
    for (int i = 0; i < 3; ++i)
      if (x[i] == low[i] || x[i] == high[i]) held[v] |= hold_of_coordinate(i);
  }
}

}  // namespace lostopos
