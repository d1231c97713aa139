#include "FoamSim/scenes/shapes/edge_distance.h"

#include <algorithm>

namespace foamsim {

using lostopos::Vertex;

std::vector<Vertex> at_edge_distance(const lostopos::SurfaceMesh& mesh, Vertex start, int distance) {
  std::vector<char> seen(mesh.vertex_slots(), 0);
  std::vector<Vertex> front{start};
  seen[start.index()] = 1;
  for (int i = 0; i < distance; ++i) {
    std::vector<Vertex> next;
    for (Vertex v : front)
      for (lostopos::Edge e : mesh.edges(v))
        for (Vertex w : mesh.vertices(e))
          if (!seen[w.index()]) {
            seen[w.index()] = 1;
            next.push_back(w);
          }
    front = std::move(next);
  }
  std::ranges::sort(front, {}, &Vertex::index);
  return front;
}

}  // namespace foamsim
