#include "FoamSim/scenes/shapes/solids.h"

#include <cmath>

namespace foamsim {

using lostopos::SurfaceMesh;
using lostopos::Vec3;
using lostopos::Vertex;

void scale(SurfaceMesh& mesh, const Vec3& factors) {
  for (Vertex v : mesh.vertices()) mesh.set_position(v, mesh.position(v).cwiseProduct(factors));
}

SurfaceMesh ellipsoid(long n, const Vec3& half_axes) {
  SurfaceMesh mesh = icosphere(n);
  scale(mesh, half_axes);
  return mesh;
}

SurfaceMesh mirrored(const SurfaceMesh& mesh) {
  SurfaceMesh image;
  image.reserve(mesh.vertex_count(), mesh.triangle_count());
  for (Vertex v : mesh.vertices()) image.add_vertex(-mesh.position(v));
  for (lostopos::Triangle t : mesh.triangles()) {
    const auto& [a, b, c] = mesh.vertices(t);
    image.add_triangle(a, c, b, mesh.labels(t));
  }
  return image;
}

void perturb_with_mode(SurfaceMesh& mesh, long mode, double amplitude) {
  for (Vertex v : mesh.vertices()) {
    const Vec3 x = mesh.position(v);
    const double legendre = std::legendre(static_cast<unsigned>(mode), x.x() / x.norm());
    mesh.set_position(v, x * (1 + amplitude * legendre));
  }
}

}  // namespace foamsim
