#include "LosTopos/shapes/indexed_surface.h"

#include <algorithm>
#include <map>

namespace lostopos {
namespace {

IndexedSurface subdivided_once(const IndexedSurface& coarse) {
  IndexedSurface fine{coarse.points, {}};
  fine.triangles.reserve(4 * coarse.triangles.size());
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> midpoints;
  auto midpoint = [&](std::uint32_t a, std::uint32_t b) {
    const auto [it, added] = midpoints.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(fine.points.size()));
    if (added) fine.points.push_back((coarse.points[a] + coarse.points[b]) / 2);
    return it->second;
  };
  for (const auto& [a, b, c] : coarse.triangles) {
    const std::uint32_t ab = midpoint(a, b), bc = midpoint(b, c), ca = midpoint(c, a);
    fine.triangles.push_back({a, ab, ca});
    fine.triangles.push_back({ab, b, bc});
    fine.triangles.push_back({ca, bc, c});
    fine.triangles.push_back({ab, bc, ca});
  }
  return fine;
}

}  // namespace

IndexedSurface subdivided(IndexedSurface surface, long times) {
  for (long i = 0; i < times; ++i) surface = subdivided_once(surface);
  return surface;
}

SurfaceMesh as_bubble(const IndexedSurface& surface) {
  SurfaceMesh mesh;
  mesh.reserve(surface.points.size(), surface.triangles.size());
  for (const Vec3& x : surface.points) mesh.add_vertex(x);
  for (const auto& [a, b, c] : surface.triangles) mesh.add_triangle(Vertex(a), Vertex(b), Vertex(c), {Region(1), air});
  return mesh;
}

}  // namespace lostopos
