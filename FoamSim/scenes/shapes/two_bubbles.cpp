#include "FoamSim/scenes/shapes/two_bubbles.h"

#include "LosTopos/shapes/solids.h"

namespace foamsim {

using lostopos::air;
using lostopos::Region;
using lostopos::SurfaceMesh;
using lostopos::Triangle;
using lostopos::Vec3;
using lostopos::Vertex;

SurfaceMesh two_bubbles(long n, double gap) {
  const SurfaceMesh unit = lostopos::icosphere(n);
  SurfaceMesh mesh;
  mesh.reserve(2 * unit.vertex_count(), 2 * unit.triangle_count());
  for (int side : {-1, 1}) {
    const std::size_t first = mesh.vertex_slots();
    for (Vertex v : unit.vertices()) {
      const Vec3& x = unit.position(v);
      mesh.add_vertex({side * (x.x() + 1 + gap / 2), x.y(), x.z()});
    }
    const Region inside(side < 0 ? 1 : 2);
    for (Triangle t : unit.triangles()) {
      const auto& [a, b, c] = unit.vertices(t);
      // The mirror image has its normals inwards.
      mesh.add_triangle(Vertex(first + a.index()), Vertex(first + b.index()), Vertex(first + c.index()),
                        side > 0 ? lostopos::Labels{inside, air} : lostopos::Labels{air, inside});
    }
  }
  return mesh;
}

}  // namespace foamsim
