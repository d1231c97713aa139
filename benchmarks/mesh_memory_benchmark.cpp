// Memory of a mesh of about 100,000 triangles with the simulation's attributes, counted at the allocator: every byte
// that is asked for while the mesh is built and stays in use afterwards.
#include <malloc.h>

#include <cstdio>

#include "FoamSim/scenes/shapes/double_bubble.h"
#include "FoamSim/sheet/circulation.h"

namespace {

std::size_t bytes_in_use() {
  const struct mallinfo2 info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

void report(const char* what, std::size_t bytes, const lostopos::SurfaceMesh& mesh) {
  std::printf("%-36s %9.1f bytes a triangle\n", what,
              static_cast<double>(bytes) / static_cast<double>(mesh.triangle_count()));
}

}  // namespace

int main() {
  const std::size_t before = bytes_in_use();
  lostopos::SurfaceMesh mesh = foamsim::double_bubble(168);
  const std::size_t with_mesh = bytes_in_use();
  const foamsim::CirculationField circulation(mesh);
  const std::size_t with_circulation = bytes_in_use();
  std::printf("double bubble, %zu triangles, %zu vertices, %zu edges\n", mesh.triangle_count(), mesh.vertex_count(),
              mesh.edge_count());
  report("mesh (heap blocks in use)", with_mesh - before, mesh);
  report("mesh with circulation", with_circulation - before, mesh);
  report("as the mesh counts itself", mesh.memory_bytes(), mesh);
  return 0;
}
