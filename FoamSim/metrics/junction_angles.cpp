#include "FoamSim/metrics/junction_angles.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>

#include "FoamSim/metrics/half_planes.h"

namespace foamsim {

using lostopos::Edge;
using lostopos::Labels;
using lostopos::Region;
using lostopos::SurfaceMesh;
using lostopos::Triangle;
using lostopos::Vec3;

namespace {

// The three half-planes at an edge.
std::array<HalfPlane, 3> half_planes(const SurfaceMesh& mesh, Edge e) {
  const auto& ends = mesh.vertices(e);
  const Vec3 axis = (mesh.position(ends[1]) - mesh.position(ends[0])).normalized();
  const Vec3 u = axis.unitOrthogonal(), w = axis.cross(u);
  std::array<HalfPlane, 3> planes;
  for (std::size_t i = 0; i < 3; ++i) {
    const Triangle t = mesh.triangles(e)[i];
    const Vec3 arm = mesh.position(mesh.opposite_vertex(t, e)) - mesh.position(ends[0]);
    const Labels labels = mesh.labels(t);
    planes[i] = {std::atan2(arm.dot(w), arm.dot(u)), mesh.runs_along(t, e) ? labels.q : labels.p};
  }
  return planes;
}

}  // namespace

JunctionAngles junction_angles(const SurfaceMesh& mesh) {
  DihedralAngles angles;
  for (Edge e : mesh.edges())
    if (mesh.triangles(e).size() == 3) angles.add(half_planes(mesh, e));
  return {angles.rms_deviation_deg(), angles.outer_mean_deg(), angles.places()};
}

}  // namespace foamsim
