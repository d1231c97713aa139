#include "tests/LosTopos/remeshing/patches.h"

#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include "LosTopos/mesh/measures.h"
#include "tests/support/sample_meshes.h"

namespace lostopos::test {

SurfaceMesh two_triangles(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  SurfaceMesh mesh;
  for (const Vec3& x : {a, b, c, d}) mesh.add_vertex(x);
  mesh.add_triangle(Vertex(0), Vertex(1), Vertex(2), film);
  mesh.add_triangle(Vertex(1), Vertex(0), Vertex(3), film);
  return mesh;
}

SurfaceMesh hexagonal_patch(int rings) {
  SurfaceMesh mesh;
  std::map<std::pair<int, int>, Vertex> known;
  auto vertex = [&](int i, int j) {
    const auto [it, fresh] = known.try_emplace({i, j});
    if (fresh) it->second = mesh.add_vertex({i + 0.5 * j, 0.5 * std::numbers::sqrt3 * j, 0});
    return it->second;
  };
  auto inside = [rings](int i, int j) {
    return std::abs(i) <= rings && std::abs(j) <= rings && std::abs(i + j) <= rings;
  };
  vertex(0, 0);
  for (int j = -rings; j <= rings; ++j)
    for (int i = -rings; i <= rings; ++i) {
      if (inside(i, j) && inside(i + 1, j) && inside(i, j + 1))
        mesh.add_triangle(vertex(i, j), vertex(i + 1, j), vertex(i, j + 1), film);
      if (inside(i + 1, j) && inside(i + 1, j + 1) && inside(i, j + 1))
        mesh.add_triangle(vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1), film);
    }
  return mesh;
}

SurfaceMesh tent(double height) {
  SurfaceMesh mesh;
  const Vertex apex = mesh.add_vertex({0, 0, height});
  for (int k = 0; k < 6; ++k) {
    const double angle = k * std::numbers::pi / 3;
    mesh.add_vertex({std::cos(angle), std::sin(angle), 0});
  }
  for (std::size_t k = 0; k < 6; ++k) mesh.add_triangle(apex, Vertex(1 + k), Vertex(1 + (k + 1) % 6), film);
  return mesh;
}

void add_pebble(SurfaceMesh& mesh, const Vec3& centre, double size, Region outside) {
  add_corner_tetrahedron(mesh, size, centre - Vec3::Constant(size / 4), Region(7), outside);
}

RemeshOptions wide_bounds() {
  RemeshOptions options;
  options.target_edge = 1;
  options.longest_edge = 100;
  options.min_area = 1e-6;
  options.min_angle = 0.01;
  options.max_angle = 179.99;
  options.max_volume_change = 100;
  return options;
}

double volume(const SurfaceMesh& mesh, Region region) {
  for (const auto& [r, v] : region_volumes(mesh))
    if (r == region) return v;
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace lostopos::test
