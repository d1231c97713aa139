#include "LosTopos/mesh/air_side.h"

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

bool touches_air(const SurfaceMesh& mesh, Vertex v) {
  return std::ranges::any_of(mesh.triangles(v), [&](Triangle t) { return mesh.labels(t).has(air); });
}

AreaBySide area_by_side(const SurfaceMesh& mesh) {
  AreaBySide areas;
  for (Triangle t : mesh.triangles()) (mesh.labels(t).has(air) ? areas.air_side : areas.shared) += area(mesh, t);
  return areas;
}

}  // namespace lostopos
