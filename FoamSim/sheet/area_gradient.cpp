#include "FoamSim/sheet/area_gradient.h"

#include <Eigen/Geometry>

#include "FoamSim/sheet/surface_geometry.h"
#include "LosTopos/mesh/for_each_living.h"

namespace foamsim {

using lostopos::Triangle;
using lostopos::Vec3;
using lostopos::Vertex;

double film_area(const lostopos::SurfaceMesh& mesh, std::span<const std::uint8_t> solid,
                 std::span<const Vec3> positions) {
  double sum = 0;
  for (Triangle t : mesh.triangles()) {
    if (is_solid(t, solid)) continue;
    const auto [a, b, c] = mesh.vertices(t);
    const Vec3& x = positions[a.index()];
    sum += 0.5 * (positions[b.index()] - x).cross(positions[c.index()] - x).norm();
  }
  return sum;
}

void add_area_gradient(const lostopos::SurfaceMesh& mesh, std::span<const std::uint8_t> solid,
                       std::span<const Vec3> positions, double factor, std::span<Vec3> gradient) {
  lostopos::for_each_vertex(mesh, [&](Vertex v) {
    Vec3 sum = Vec3::Zero();
    for (Triangle t : mesh.triangles(v)) {
      if (is_solid(t, solid)) continue;
      const auto corners = mesh.vertices(t);
      std::size_t k = 0;
      while (corners[k] != v) ++k;
      const Vec3& a = positions[v.index()];
      const Vec3& b = positions[corners[(k + 1) % 3].index()];
      const Vec3& c = positions[corners[(k + 2) % 3].index()];
      const Vec3 normal = (b - a).cross(c - a);
      const double size = normal.norm();
      if (size > 0) sum += normal.cross(c - b) / (2 * size);
    }
    gradient[v.index()] += factor * sum;
  });
}

}  // namespace foamsim
