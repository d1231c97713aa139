#include "FoamSim/constraints/border_chain.h"

#include <algorithm>

#include "Base/error.h"

namespace foamsim {

using lostopos::Edge;
using lostopos::SurfaceMesh;
using lostopos::Vertex;

namespace {

std::vector<Vertex> border_neighbours(const SurfaceMesh& mesh, std::span<const lostopos::Hold> held, Vertex v) {
  std::vector<Vertex> neighbours;
  for (Edge e : mesh.edges(v)) {
    const Vertex other = mesh.other_vertex(e, v);
    if (mesh.triangles(e).size() == 1 && is_held(held[other.index()])) neighbours.push_back(other);
  }
  std::ranges::sort(neighbours);
  return neighbours;
}

}  // namespace

std::vector<Vertex> border_chain(const SurfaceMesh& mesh, std::span<const lostopos::Hold> held) {
  std::vector<Vertex> all, ends;
  for (Vertex v : mesh.vertices()) {
    if (!is_held(held[v.index()])) continue;
    all.push_back(v);
    const std::size_t neighbours = border_neighbours(mesh, held, v).size();
    if (neighbours == 1) ends.push_back(v);
    if (neighbours == 0 || neighbours > 2)
      throw base::InputError(
          "vertex " + std::to_string(v.index()) + " of the rod has " + std::to_string(neighbours) +
          " neighbours along the films' border; the vertices of a rod form a chain, with one or two");
  }
  if (all.size() < 3)
    throw base::InputError("a rod needs three or more held vertices along the films' border; the start mesh has " +
                           std::to_string(all.size()));
  std::vector<Vertex> chain{ends.empty() ? all.front() : ends.front()};
  std::vector<char> seen(mesh.vertex_slots(), 0);
  seen[chain.front().index()] = 1;
  for (bool grows = true; grows;) {
    grows = false;
    for (Vertex next : border_neighbours(mesh, held, chain.back()))
      if (seen[next.index()] == 0) {
        seen[next.index()] = 1;
        chain.push_back(next);
        grows = true;
        break;
      }
  }
  if (chain.size() != all.size())
    throw base::InputError("the vertices of the rod form more than one chain: " + std::to_string(chain.size()) +
                           " of " + std::to_string(all.size()) + " are joined to the first");
  return chain;
}

}  // namespace foamsim
