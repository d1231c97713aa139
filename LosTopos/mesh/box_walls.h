#pragma once

#include "LosTopos/mesh/hold.h"

namespace lostopos {

/// Lets the vertices on the walls of the box from `low` to `high` slide: each holds the coordinates in which it is at
/// either to the bit, in addition to what it holds already.
inline void hold_in_box_walls(const SurfaceMesh& mesh, VertexAttribute<char>& held, const Vec3& low, const Vec3& high) {
  for (Vertex v : mesh.vertices()) {
    const Vec3& x = mesh.position(v);
    for (int i = 0; i < 3; ++i)
      if (x[i] == low[i] || x[i] == high[i]) held[v] = static_cast<char>(held[v] | (hold_x << i));
  }
}

}  // namespace lostopos
