#pragma once

#include <array>

#include "LosTopos/mesh/surface_mesh.h"

namespace lostopos {

/// Whether the surface is anything but one smooth film at e: a junction, or the free end of a film.
inline bool is_border(const SurfaceMesh& mesh, Edge e) {
  return mesh.triangles(e).size() != 2;
}

/// How much a vertex is bound by the films that meet there; more is greater.
enum class VertexRank {
  film,    ///< within one film
  border,  ///< on a curve where the same films meet all along, or where one film ends: it may slide along the curve
  corner,  ///< where such curves meet, end or change (a Plateau vertex): it stays
};
VertexRank rank(const SurfaceMesh& mesh, Vertex v);

/// The first two border edges at v in the order of its edges (invalid when there are fewer), and their number.
struct BorderEdges {
  std::array<Edge, 2> first;
  int count = 0;
};
BorderEdges border_edges(const SurfaceMesh& mesh, Vertex v);

}  // namespace lostopos
