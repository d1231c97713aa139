#include "kelvin_cell.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

namespace foamsim::test {

using lostopos::Region;
using lostopos::SurfaceMesh;
using lostopos::Vec3;
using lostopos::Vertex;

namespace {

// The permutations of (0, ±1, ±2).
std::vector<Vec3> corners() {
  std::vector<Vec3> found;
  for (int x = -2; x <= 2; ++x)
    for (int y = -2; y <= 2; ++y)
      for (int z = -2; z <= 2; ++z)
        if (x * y * z == 0 && std::abs(x) + std::abs(y) + std::abs(z) == 3 && x * x + y * y + z * z == 5)
          found.emplace_back(x, y, z);
  return found;
}

// Outward normals of six squares and eight hexagons, each with its corners' distance along it.
std::vector<std::pair<Vec3, double>> planes() {
  std::vector<std::pair<Vec3, double>> found;
  for (int axis = 0; axis < 3; ++axis)
    for (int sign : {-1, 1}) found.emplace_back(sign * Vec3::Unit(axis), 2);
  for (int x : {-1, 1})
    for (int y : {-1, 1})
      for (int z : {-1, 1}) found.emplace_back(Vec3(x, y, z), 3);
  return found;
}

// Indices of the corners in a plane, counter-clockwise as seen from outside.
std::vector<std::size_t> face_of(const std::vector<Vec3>& points, const Vec3& normal, double distance) {
  std::vector<std::size_t> face;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (std::abs(points[i].dot(normal) - distance) < 1e-9) face.push_back(i);
  const Vec3 u = normal.unitOrthogonal(), w = normal.normalized().cross(u);
  std::ranges::sort(face, {}, [&](std::size_t i) { return std::atan2(points[i].dot(w), points[i].dot(u)); });
  return face;
}

}  // namespace

SurfaceMesh kelvin_cell() {
  const std::vector<Vec3> points = corners();
  SurfaceMesh mesh;
  std::vector<Vertex> inner, outer;
  for (const Vec3& x : points) inner.push_back(mesh.add_vertex(x));
  for (const Vec3& x : points) outer.push_back(mesh.add_vertex(1.5 * x));
  std::map<std::pair<std::size_t, std::size_t>, Region> across;  // by side, as its face runs along it
  std::uint32_t region = 2;
  for (const auto& [normal, distance] : planes()) {
    const std::vector<std::size_t> face = face_of(points, normal, distance);
    for (std::size_t k = 0; k < face.size(); ++k) {
      across[{face[k], face[(k + 1) % face.size()]}] = Region{region};
      if (k >= 2) mesh.add_triangle(inner[face[0]], inner[face[k - 1]], inner[face[k]], {Region{1}, Region{region}});
    }
    ++region;
  }
  for (const auto& [side, left] : across) {
    const auto [a, b] = side;
    if (a > b) continue;
    const Region right = across.at({b, a});
    mesh.add_triangle(inner[a], inner[b], outer[b], {right, left});
    mesh.add_triangle(inner[a], outer[b], outer[a], {right, left});
  }
  return mesh;
}

}  // namespace foamsim::test
