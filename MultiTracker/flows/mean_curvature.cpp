#include "MultiTracker/flows/mean_curvature.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "LosTopos/mesh/for_each_living.h"
#include "LosTopos/mesh/hold.h"

namespace multitracker {

using lostopos::Vec3;
using lostopos::Vertex;

namespace {

constexpr double resolved_share = 0.9;  // of the vertices, whose stable dt is kept to
constexpr double safety = 0.5;          // of that dt
constexpr double largest_share = 0.5;   // of a triangle's height that a vertex moves in a substep
constexpr int most_substeps = 64;
constexpr double least_sine = 1e-6;  // of a corner's angle, for finite cotangents

struct Motion {
  Vec3 velocity = Vec3::Zero();
  double stable_dt = 0;  // zero: does not move
  double largest = 0;    // displacement in a substep
};

double cotangent(const Vec3& u, const Vec3& v) {
  const double dot = u.dot(v), cross = u.cross(v).norm();
  return dot / std::max(cross, least_sine * u.norm() * v.norm());
}

Motion motion_of(const lostopos::SurfaceMesh& mesh, const std::vector<Vec3>& x, Vertex v) {
  Vec3 gradient = Vec3::Zero();
  double weights = 0, area = 0, height = std::numeric_limits<double>::infinity();
  for (lostopos::Triangle t : mesh.triangles(v)) {
    const auto& corners = mesh.vertices(t);
    const auto i = static_cast<std::size_t>(std::ranges::find(corners, v) - corners.begin());
    const Vec3 &a = x[v.index()], &b = x[corners[(i + 1) % 3].index()], &c = x[corners[(i + 2) % 3].index()];
    const double at_b = cotangent(a - b, c - b) / 2, at_c = cotangent(a - c, b - c) / 2;
    if (!std::isfinite(at_b) || !std::isfinite(at_c)) continue;  // two corners in one place
    gradient += at_c * (a - b) + at_b * (a - c);
    weights += std::abs(at_b) + std::abs(at_c);
    const double twice_area = (b - a).cross(c - a).norm();
    area += twice_area / 2;
    height = std::min(
        height,
        twice_area / std::sqrt(std::max({(b - a).squaredNorm(), (c - a).squaredNorm(), (c - b).squaredNorm()})));
  }
  if (!(area > 0 && weights > 0)) return {};
  return {-3 / area * gradient, area / (3 * weights), largest_share * height};
}

std::vector<Motion> motions(const lostopos::SurfaceMesh& mesh, const std::vector<Vec3>& x) {
  std::vector<Motion> all(x.size());
  lostopos::for_each_vertex(mesh, [&](Vertex v) { all[v.index()] = motion_of(mesh, x, v); });
  return all;
}

// Stable at nine tenths of the vertices.
double resolved_dt(const std::vector<Motion>& motions) {
  std::vector<double> stable;
  for (const Motion& motion : motions)
    if (motion.stable_dt > 0) stable.push_back(motion.stable_dt);
  if (stable.empty()) return 0;
  const auto place =
      stable.begin() + static_cast<std::ptrdiff_t>((1 - resolved_share) * static_cast<double>(stable.size()));
  std::ranges::nth_element(stable, place);
  return safety * *place;
}

}  // namespace

std::vector<Vec3> MeanCurvatureFlow::predicted(const FlowStep& step) const {
  std::vector<Vec3> x(step.mesh.positions().begin(), step.mesh.positions().end());
  double left = mobility_ * step.dt;
  for (int substep = 1; substep <= most_substeps && left > 0; ++substep) {
    const std::vector<Motion> now = motions(step.mesh, x);
    const double resolved = resolved_dt(now);
    if (!(resolved > 0)) break;
    const double dt = substep == most_substeps ? left : std::min(left, resolved);
    for (Vertex v : step.mesh.vertices()) {
      const Motion& motion = now[v.index()];
      Vec3 way = std::min(dt, motion.stable_dt) * lostopos::free_part(step.held[v.index()], motion.velocity);
      if (const double length = way.norm(); length > motion.largest) way *= motion.largest / length;
      x[v.index()] += way;
    }
    left -= dt;
  }
  return x;
}

}  // namespace multitracker
