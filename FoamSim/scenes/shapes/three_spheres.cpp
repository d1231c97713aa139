#include "FoamSim/scenes/shapes/three_spheres.h"

#include <array>
#include <numbers>

#include "LosTopos/shapes/solids.h"

namespace foamsim {

using lostopos::Region;
using lostopos::SurfaceMesh;
using lostopos::Vec3;
using lostopos::Vertex;

SurfaceMesh three_spheres(long n) {
  const double z = std::numbers::sqrt3 / 2;
  const std::array<Vec3, 3> centres{Vec3(1, 0, 0), Vec3(-0.5, 0, -z), Vec3(-0.5, 0, z)};
  const SurfaceMesh ball = lostopos::icosphere(n, 0.5);
  SurfaceMesh mesh;
  mesh.reserve(3 * ball.vertex_count(), 3 * ball.triangle_count());
  for (std::size_t i = 0; i < centres.size(); ++i) {
    const std::size_t first = mesh.vertex_slots();
    for (Vertex v : ball.vertices()) mesh.add_vertex(centres.at(i) + ball.position(v));
    for (lostopos::Triangle t : ball.triangles()) {
      const auto& [a, b, c] = ball.vertices(t);
      mesh.add_triangle(Vertex(first + a.index()), Vertex(first + b.index()), Vertex(first + c.index()),
                        {Region(i + 1), lostopos::air});
    }
  }
  return mesh;
}

}  // namespace foamsim
