#include "tests/support/film_meshes.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>

#include "LosTopos/shapes/circle_films.h"

namespace lostopos::test {
namespace {

using std::numbers::pi;
template <class Lists>
bool same_lists(const Lists& a, const Lists& b) {
  return std::ranges::equal(a, b, [](const auto& x, const auto& y) { return std::ranges::equal(x, y); });
}

bool same_pool(const SlotPool& a, const SlotPool& b) {
  return a.alive() == b.alive() && a.free() == b.free();
}

}  // namespace

SurfaceMesh analytic_double_bubble(double radius, long segments) {
  const std::array films{CircleFilm{-2 * pi / 3, {air, Region(1)}}, CircleFilm{2 * pi / 3, {Region(2), air}},
                         CircleFilm{0, {Region(1), Region(2)}}};
  return films_on_circle(radius * std::numbers::sqrt3 / 2, films, segments);
}

double analytic_bubble_volume(double radius) {
  return 9 * pi / 8 * radius * radius * radius;
}

CubeFrame cube_frame(long k) {
  CubeFrame cube;
  std::map<std::array<long, 3>, Vertex> known;
  auto vertex = [&](const std::array<long, 3>& key) {
    const auto [it, fresh] = known.try_emplace(key);
    if (fresh) {
      const Vec3 x = Vec3(static_cast<double>(key[0]), static_cast<double>(key[1]), static_cast<double>(key[2]));
      it->second = cube.mesh.add_vertex(x / static_cast<double>(k));
      if (std::ranges::count_if(key, [k](long c) { return std::abs(c) == k; }) >= 2) cube.frame.push_back(it->second);
    }
    return it->second;
  };
  vertex({0, 0, 0});
  auto face = [](std::size_t axis, long sign) { return Region(1 + 2 * axis + (sign > 0 ? 1 : 0)); };
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (long su : {-1L, 1L})
      for (long sv : {-1L, 1L}) {
        const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
        std::array<long, 3> a{}, b{};
        a[axis] = -1, b[axis] = 1;
        a[u] = b[u] = su;
        a[v] = b[v] = sv;
        // The normal of (centre, a, b), a × b, has the components (0, 2 sv, −2 su) along (axis, u, v).
        const Labels labels = su * sv > 0 ? Labels{face(v, sv), face(u, su)} : Labels{face(u, su), face(v, sv)};
        auto at = [&](long i, long j) {
          return vertex({i * a[0] + j * b[0], i * a[1] + j * b[1], i * a[2] + j * b[2]});
        };
        for (long i = 0; i < k; ++i)
          for (long j = 0; i + j < k; ++j) {
            cube.mesh.add_triangle(at(i, j), at(i + 1, j), at(i, j + 1), labels);
            if (i + j + 1 < k) cube.mesh.add_triangle(at(i + 1, j), at(i + 1, j + 1), at(i, j + 1), labels);
          }
      }
  return cube;
}

bool same_bits(const SurfaceMesh::State& a, const SurfaceMesh::State& b) {
  const bool same_positions = a.positions.size() == b.positions.size() &&
                              std::ranges::equal(a.positions, b.positions, [](const Vec3& x, const Vec3& y) {
                                return std::bit_cast<std::array<std::uint64_t, 3>>(std::array{x[0], x[1], x[2]}) ==
                                       std::bit_cast<std::array<std::uint64_t, 3>>(std::array{y[0], y[1], y[2]});
                              });
  return same_positions && same_pool(a.vertices, b.vertices) && same_pool(a.edges, b.edges) &&
         same_pool(a.triangles, b.triangles) && same_lists(a.vertex_edges, b.vertex_edges) &&
         same_lists(a.vertex_triangles, b.vertex_triangles) && a.edge_vertices == b.edge_vertices &&
         same_lists(a.edge_triangles, b.edge_triangles) && a.triangle_vertices == b.triangle_vertices &&
         a.triangle_edges == b.triangle_edges && a.labels == b.labels;
}

}  // namespace lostopos::test
