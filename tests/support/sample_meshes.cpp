#include "tests/support/sample_meshes.h"

#include <cmath>
#include <numbers>

namespace lostopos::test {

void add_corner_tetrahedron(SurfaceMesh& mesh, double size, const Vec3& shift, Region inside, Region outside) {
  const Vertex o = mesh.add_vertex(shift);
  const Vertex x = mesh.add_vertex(shift + Vec3(size, 0, 0));
  const Vertex y = mesh.add_vertex(shift + Vec3(0, size, 0));
  const Vertex z = mesh.add_vertex(shift + Vec3(0, 0, size));
  mesh.add_triangle(o, y, x, {inside, outside});
  mesh.add_triangle(o, x, z, {inside, outside});
  mesh.add_triangle(o, z, y, {inside, outside});
  mesh.add_triangle(x, y, z, {inside, outside});
}

SurfaceMesh corner_tetrahedron(double size, const Vec3& shift) {
  SurfaceMesh mesh;
  add_corner_tetrahedron(mesh, size, shift, Region(1), air);
  return mesh;
}

SurfaceMesh globe(double radius, long n, const Vec3& centre) {
  constexpr Labels outwards{Region(1), air};
  const long segments = 2 * n;
  SurfaceMesh mesh;
  const Vertex left = mesh.add_vertex(centre - Vec3(radius, 0, 0));
  for (long ring = 1; ring < n; ++ring)
    for (long k = 0; k < segments; ++k) {
      const double polar = std::numbers::pi * static_cast<double>(ring) / static_cast<double>(n);
      const double turn = std::numbers::pi * static_cast<double>(k) / static_cast<double>(n);
      mesh.add_vertex(
          centre + radius * Vec3(-std::cos(polar), std::sin(polar) * std::cos(turn), std::sin(polar) * std::sin(turn)));
    }
  const Vertex right = mesh.add_vertex(centre + Vec3(radius, 0, 0));
  auto vertex = [segments](long ring, long k) {
    return Vertex(static_cast<std::size_t>(1 + (ring - 1) * segments + k % segments));
  };
  for (long k = 0; k < segments; ++k) {
    mesh.add_triangle(left, vertex(1, k + 1), vertex(1, k), outwards);
    for (long ring = 1; ring + 1 < n; ++ring) {
      mesh.add_triangle(vertex(ring, k), vertex(ring + 1, k + 1), vertex(ring + 1, k), outwards);
      mesh.add_triangle(vertex(ring, k), vertex(ring, k + 1), vertex(ring + 1, k + 1), outwards);
    }
    mesh.add_triangle(right, vertex(n - 1, k), vertex(n - 1, k + 1), outwards);
  }
  return mesh;
}

SurfaceMesh open_cylinder(double radius, long segments, long rings, double spacing) {
  SurfaceMesh mesh;
  for (long i = 0; i <= rings; ++i)
    for (long k = 0; k < segments; ++k) {
      const double angle = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(segments);
      mesh.add_vertex({spacing * static_cast<double>(i), radius * std::cos(angle), radius * std::sin(angle)});
    }
  auto vertex = [segments](long ring, long k) {
    return Vertex(static_cast<std::size_t>(ring * segments + k % segments));
  };
  for (long i = 0; i < rings; ++i)
    for (long k = 0; k < segments; ++k) {
      mesh.add_triangle(vertex(i, k), vertex(i + 1, k + 1), vertex(i + 1, k), {Region(1), air});
      mesh.add_triangle(vertex(i, k), vertex(i, k + 1), vertex(i + 1, k + 1), {Region(1), air});
    }
  return mesh;
}

}  // namespace lostopos::test
