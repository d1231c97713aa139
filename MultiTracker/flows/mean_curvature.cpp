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

Motion motion_of(const lostopos::SurfaceMesh& mesh, const std::vector<Vec3>& x, Vertex v) {
  Vec3 gradient = Vec3::Zero();
  double weights = 0, area = 0, height = std::numeric_limits<double>::infinity();
  for (lostopos::Triangle t : mesh.triangles(v)) {
    const auto& corners = mesh.vertices(t);
    const auto i = static_cast<std::size_t>(std::ranges::find(corners, v) - corners.begin());
    const Vec3& a = x[v.index()];
    const Vec3 ab = x[corners[(i + 1) % 3].index()] - a, ac = x[corners[(i + 2) % 3].index()] - a, bc = ac - ab;
    const double twice_area = ab.cross(ac).norm(), b = ab.norm(), c = ac.norm(), across = bc.norm();
    // Half the cotangents at b and c.
    const double at_b = -ab.dot(bc) / (2 * std::max(twice_area, least_sine * b * across));
    const double at_c = ac.dot(bc) / (2 * std::max(twice_area, least_sine * c * across));
    if (!std::isfinite(at_b) || !std::isfinite(at_c)) continue;  // two corners in one place
    gradient -= at_c * ab + at_b * ac;
    weights += std::abs(at_b) + std::abs(at_c);
    area += twice_area / 2;
    height = std::min(height, twice_area / std::max({b, c, across}));
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
