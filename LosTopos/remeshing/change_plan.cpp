#include "LosTopos/remeshing/change_plan.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "LosTopos/geometry/triangle_quality.h"
#include "LosTopos/mesh/measures.h"
#include "LosTopos/remeshing/invariants/volume.h"

namespace lostopos {

ShapeSummary ShapeSummary::of_none() {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return {infinity, 0, infinity, 0};
}

void ShapeSummary::add(const Corners& corners) {
  const auto& [a, b, c] = corners;
  const Vec3 angles = triangle_angles(a, b, c);
  min_angle = std::min(min_angle, angles.minCoeff());
  max_angle = std::max(max_angle, angles.maxCoeff());
  min_area = std::min(min_area, triangle_area(a, b, c));
  longest_edge = std::max({longest_edge, (b - a).norm(), (c - b).norm(), (a - c).norm()});
}

void ChangePlan::clear() {
  replaced.clear();
  triangles.clear();
}

void ChangePlan::add_moved(const SurfaceMesh& mesh, Triangle t, Vertex from, Vertex to, const Vec3& position) {
  PlannedTriangle planned{
      mesh.vertices(t), corners(mesh, t), mesh.labels(t), t, 2 * area_vector(mesh, t), from == to,
  };
  for (std::size_t i = 0; i < 3; ++i) {
    if (planned.vertices[i] != from) continue;
    planned.vertices[i] = to;
    planned.corners[i] = position;
  }
  triangles.push_back(planned);
}

void ChangePlan::move(Vertex vertex, const Vec3& position) {
  for (PlannedTriangle& planned : triangles)
    for (std::size_t i = 0; i < 3; ++i)
      if (planned.vertices[i] == vertex) planned.corners[i] = position;
}

void ChangePlan::measure(const SurfaceMesh& mesh) {
  before = after = ShapeSummary::of_none();
  for (Triangle t : replaced) before.add(corners(mesh, t));
  for (const PlannedTriangle& planned : triangles) after.add(planned.corners);
  measure_volumes(mesh);
}

void ChangePlan::measure_volumes(const SurfaceMesh& mesh) {
  volume_change = VolumeChange(mesh, *this).largest();
}

}  // namespace lostopos
