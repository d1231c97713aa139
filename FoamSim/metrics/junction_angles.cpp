#include "FoamSim/metrics/junction_angles.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace foamsim {

using lostopos::Edge;
using lostopos::Labels;
using lostopos::Region;
using lostopos::SurfaceMesh;
using lostopos::Triangle;
using lostopos::Vec3;

namespace {

struct HalfPlane {
  double angle;         // about the edge, counter-clockwise
  Region region_after;  // the region met when the turn goes on
};

// The three half-planes at an edge in the order of a turn about it.
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
  std::ranges::sort(planes, {}, &HalfPlane::angle);
  return planes;
}

}  // namespace

JunctionAngles junction_angles(const SurfaceMesh& mesh) {
  double squares = 0, outer_sum = 0;
  std::size_t edges = 0, outer = 0;
  for (Edge e : mesh.edges()) {
    if (mesh.triangles(e).size() != 3) continue;
    ++edges;
    const auto planes = half_planes(mesh, e);
    for (std::size_t i = 0; i < 3; ++i) {
      double angle = planes[(i + 1) % 3].angle - planes[i].angle;
      if (i == 2) angle += 2 * std::numbers::pi;
      const double degrees = angle * 180 / std::numbers::pi;
      squares += (degrees - 120) * (degrees - 120);
      if (planes[i].region_after == lostopos::air) {
        outer_sum += degrees;
        ++outer;
      }
    }
  }
  JunctionAngles angles;
  angles.edges = edges;
  if (edges > 0) angles.rms_deviation_deg = std::sqrt(squares / (3.0 * static_cast<double>(edges)));
  if (outer > 0) angles.outer_mean_deg = outer_sum / static_cast<double>(outer);
  return angles;
}

}  // namespace foamsim
