#include "LosTopos/mesh/air_side.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "LosTopos/mesh/measures.h"

namespace lostopos {

Vec3 air_side_area_vector(const SurfaceMesh& mesh, Vertex v) {
  Vec3 sum = Vec3::Zero();
  for (Triangle t : mesh.triangles(v)) {
    // The right-hand normal points from p into q.
    if (mesh.labels(t).q == air)
      sum += area_vector(mesh, t);
    else if (mesh.labels(t).p == air)
      sum -= area_vector(mesh, t);
  }
  return sum;
}

Vec3 air_side_normal(const SurfaceMesh& mesh, Vertex v) {
  const Vec3 sum = air_side_area_vector(mesh, v);
  const double length = sum.norm();
  return length > 0 ? Vec3(sum / length) : Vec3::Zero();
}

Vec3 air_side_normal(const SurfaceMesh& mesh, Vertex v, std::span<const Vec3> positions) {
  Vec3 sum = Vec3::Zero();
  for (Triangle t : mesh.triangles(v)) {
    if (!mesh.labels(t).has(air)) continue;
    const auto& [a, b, c] = mesh.vertices(t);
    const Vec3& origin = positions[a.index()];
    const Vec3 twice_area = (positions[b.index()] - origin).cross(positions[c.index()] - origin);
    sum += mesh.labels(t).q == air ? twice_area : Vec3(-twice_area);
  }
  const double length = sum.norm();
  return length > 0 ? Vec3(sum / length) : Vec3::Zero();
}

bool touches_air(const SurfaceMesh& mesh, Vertex v) {
  return std::ranges::any_of(mesh.triangles(v), [&](Triangle t) { return mesh.labels(t).has(air); });
}

AreaBySide area_by_side(const SurfaceMesh& mesh) {
  AreaBySide areas;
  for (Triangle t : mesh.triangles()) (mesh.labels(t).has(air) ? areas.air_side : areas.shared) += area(mesh, t);
  return areas;
}

}  // namespace lostopos
