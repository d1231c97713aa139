#include "tests/LosTopos/topology/clusters.h"

#include <algorithm>

#include "LosTopos/mesh/measures.h"
#include "LosTopos/shapes/film_polygons.h"
#include "LosTopos/shapes/solids.h"
#include "LosTopos/topology/sectors.h"

namespace lostopos::test {

void add_copy(SurfaceMesh& mesh, const SurfaceMesh& part, const Vec3& shift, Region region) {
  std::vector<Vertex> copies(part.vertex_slots());
  for (Vertex v : part.vertices()) copies[v.index()] = mesh.add_vertex(part.position(v) + shift);
  auto renamed = [region](Region r) { return r == Region(1) ? region : r; };
  for (Triangle t : part.triangles()) {
    const auto& [a, b, c] = part.vertices(t);
    const Labels labels = part.labels(t);
    mesh.add_triangle(copies[a.index()], copies[b.index()], copies[c.index()], {renamed(labels.p), renamed(labels.q)});
  }
}

SurfaceMesh two_spheres(long n, double gap, Region left, Region right) {
  SurfaceMesh mesh;
  const SurfaceMesh sphere = icosphere(n);
  add_copy(mesh, sphere, {-1 - gap / 2, 0, 0}, left);
  // Turned by a half about y, so that the two have no mirror symmetry where they meet.
  SurfaceMesh turned = icosphere(n);
  for (Vertex v : turned.vertices()) {
    const Vec3 x = turned.position(v);
    turned.set_position(v, {-x[0], x[1], -x[2]});
  }
  add_copy(mesh, turned, {1 + gap / 2, 0, 0}, right);
  return mesh;
}

SurfaceMesh corner_tetrahedron_pair(double gap, Region first, Region second) {
  SurfaceMesh mesh;
  for (double side : {-1.0, 1.0}) {
    const double x = side * gap / 2;
    const std::array<Vertex, 4> v = {mesh.add_vertex({x, 0, 0}), mesh.add_vertex({x, 1, 0}), mesh.add_vertex({x, 0, 1}),
                                     mesh.add_vertex({x + side, 0.3, 0.3})};
    // (0, 1, 2) turns about +x, which is out of the tetrahedron on the left.
    const Region region = side < 0 ? first : second;
    const Labels outwards = side < 0 ? Labels{region, air} : Labels{air, region};
    mesh.add_triangle(v[0], v[1], v[2], outwards);
    mesh.add_triangle(v[1], v[0], v[3], outwards);
    mesh.add_triangle(v[2], v[1], v[3], outwards);
    mesh.add_triangle(v[0], v[2], v[3], outwards);
  }
  return mesh;
}

SurfaceMesh four_columns(const std::array<Region, 4>& regions) {
  FilmPolygons foam;
  for (double z : {0.0, 1.0})
    for (double y : {-1.0, 0.0, 1.0})
      for (double x : {-1.0, 0.0, 1.0}) foam.corners.push_back({{x, y, z}, {}});
  auto corner = [](int x, int y, int z) {
    const int number = 9 * z + 3 * (y + 1) + x + 1;
    return static_cast<std::size_t>(number);
  };
  constexpr std::array<std::array<int, 2>, 4> axes = {{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
  for (std::size_t i = 0; i < 4; ++i) {
    const auto [ax, ay] = axes[i];
    const auto [bx, by] = axes[(i + 1) % 4];
    const Region here = regions[i], previous = regions[(i + 3) % 4];
    const std::array<int, 2> outer = {ax + bx, ay + by};
    foam.films.push_back({{corner(0, 0, 0), corner(ax, ay, 0), corner(ax, ay, 1), corner(0, 0, 1)}, {here, previous}});
    foam.films.push_back(
        {{corner(ax, ay, 0), corner(outer[0], outer[1], 0), corner(outer[0], outer[1], 1), corner(ax, ay, 1)},
         {here, air}});
    foam.films.push_back(
        {{corner(outer[0], outer[1], 0), corner(bx, by, 0), corner(bx, by, 1), corner(outer[0], outer[1], 1)},
         {here, air}});
    foam.films.push_back(
        {{corner(0, 0, 1), corner(ax, ay, 1), corner(outer[0], outer[1], 1), corner(bx, by, 1)}, {here, air}});
    foam.films.push_back(
        {{corner(0, 0, 0), corner(bx, by, 0), corner(outer[0], outer[1], 0), corner(ax, ay, 0)}, {here, air}});
  }
  return triangulated(foam, 1);
}

double film_area(const SurfaceMesh& mesh, Region a, Region b) {
  double sum = 0;
  for (Triangle t : mesh.triangles())
    if (mesh.labels(t).has(a) && mesh.labels(t).has(b)) sum += area(mesh, t);
  return sum;
}

bool all_complete(const SurfaceMesh& mesh) {
  return std::ranges::all_of(mesh.vertices(), [&](Vertex v) { return is_complete(mesh, v); });
}

}  // namespace lostopos::test
