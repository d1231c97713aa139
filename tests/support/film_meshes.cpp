#include "tests/support/film_meshes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <numbers>

namespace lostopos::test {
namespace {

using std::numbers::pi;
using Ring = std::vector<Vertex>;

Ring add_ring(SurfaceMesh& mesh, double x, double radius, long segments, double phase) {
  Ring ring;
  for (long k = 0; k < segments; ++k) {
    const double angle = 2 * pi * (static_cast<double>(k) + phase) / static_cast<double>(segments);
    ring.push_back(mesh.add_vertex({x, radius * std::cos(angle), radius * std::sin(angle)}));
  }
  return ring;
}

// Triangles between two rings, the shorter diagonal first; right-hand normals along +x for an inner ring that is
// smaller, in the plane's case.
void stitch(SurfaceMesh& mesh, const Ring& outer, const Ring& inner, Labels labels) {
  std::size_t i = 0, j = 0;
  auto at = [](const Ring& ring, std::size_t k) { return ring[k % ring.size()]; };
  auto distance = [&mesh](Vertex a, Vertex b) { return (mesh.position(a) - mesh.position(b)).norm(); };
  while (i < outer.size() || j < inner.size()) {
    const bool advance_outer = j == inner.size() || (i < outer.size() && distance(at(outer, i + 1), at(inner, j)) <=
                                                                             distance(at(outer, i), at(inner, j + 1)));
    if (advance_outer) {
      mesh.add_triangle(at(outer, i), at(outer, i + 1), at(inner, j), labels);
      ++i;
    } else {
      mesh.add_triangle(at(outer, i), at(inner, j + 1), at(inner, j), labels);
      ++j;
    }
  }
}

// From the rim to a pole; `profile(s)` gives x and the distance from the axis for s from 0 at the rim to 1.
void add_sheet(SurfaceMesh& mesh, const Ring& rim, double length, double edge,
               const std::function<std::array<double, 2>(double)>& profile, Labels labels) {
  const long rows = std::max(1L, std::lround(length / (edge * std::numbers::sqrt3 / 2)));
  Ring outer = rim;
  for (long row = 1; row < rows; ++row) {
    const auto [x, distance] = profile(static_cast<double>(row) / static_cast<double>(rows));
    const long segments = std::max(5L, std::lround(2 * pi * distance / edge));
    const Ring inner = add_ring(mesh, x, distance, segments, row % 2 == 0 ? 0 : 0.5);
    stitch(mesh, outer, inner, labels);
    outer = inner;
  }
  const Vertex pole = mesh.add_vertex({profile(1)[0], 0, 0});
  for (std::size_t k = 0; k < outer.size(); ++k)
    mesh.add_triangle(outer[k], outer[(k + 1) % outer.size()], pole, labels);
}

template <class Lists>
bool same_lists(const Lists& a, const Lists& b) {
  return std::ranges::equal(a, b, [](const auto& x, const auto& y) { return std::ranges::equal(x, y); });
}

bool same_pool(const SlotPool& a, const SlotPool& b) {
  return a.alive() == b.alive() && a.free() == b.free();
}

}  // namespace

SurfaceMesh analytic_double_bubble(double radius, long segments) {
  SurfaceMesh mesh;
  const double rim_radius = radius * std::numbers::sqrt3 / 2;
  const double edge = 2 * pi * rim_radius / static_cast<double>(segments);
  const Ring rim = add_ring(mesh, 0, rim_radius, segments, 0);
  for (int side : {-1, 1}) {
    // The polar angle goes from 120° at the rim to 0.
    auto cap = [&](double s) {
      const double angle = 2 * pi / 3 * (1 - s);
      return std::array{side * radius * (0.5 + std::cos(angle)), radius * std::sin(angle)};
    };
    // Rings turn about +x, so that normals point along +x at the pole: outwards on the right only.
    const Labels labels = side > 0 ? Labels{Region(2), air} : Labels{air, Region(1)};
    add_sheet(mesh, rim, 2 * pi / 3 * radius, edge, cap, labels);
  }
  auto disc = [&](double s) { return std::array{0.0, rim_radius * (1 - s)}; };
  add_sheet(mesh, rim, rim_radius, edge, disc, {Region(1), Region(2)});
  return mesh;
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
