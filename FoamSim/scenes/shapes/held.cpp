#include "FoamSim/scenes/shapes/held.h"

#include <algorithm>
#include <vector>

#include "LosTopos/remeshing/hold_transfer.h"

namespace foamsim {

using lostopos::SurfaceMesh;
using lostopos::Vertex;

void mark_held(SurfaceMesh& mesh, std::span<const Vertex> vertices) {
  auto hold = lostopos::add_hold_attribute(mesh);
  for (Vertex v : vertices) hold[v] = lostopos::Hold::all;
  std::move(hold).leave();
  mark_solids(mesh, vertices);
}

void mark_solids(SurfaceMesh& mesh, std::span<const Vertex> held) {
  std::vector<char> is_held(mesh.vertex_slots(), 0);
  for (Vertex v : held) is_held[v.index()] = 1;
  auto solid = mesh.add_triangle_attribute<std::uint8_t>("solid", lostopos::carry::copy);
  for (lostopos::Triangle t : mesh.triangles())
    solid[t] = std::ranges::all_of(mesh.vertices(t), [&](Vertex v) { return is_held[v.index()] != 0; }) ? 1 : 0;
  std::move(solid).leave();
}

}  // namespace foamsim
