#include "LosTopos/remeshing/invariants/volume.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "LosTopos/mesh/measures.h"

namespace lostopos {

VolumeChange::VolumeChange(const SurfaceMesh& mesh, const ChangePlan& plan, Vertex moving) {
  if (plan.triangles.empty()) return;
  // Any point near by: the boundary of the change is the same before and after.
  const Vec3 origin = plan.triangles.front().corners[0];
  for (Triangle t : plan.replaced) add(corners(mesh, t), mesh.labels(t), -1, origin);
  for (const PlannedTriangle& planned : plan.triangles) {
    add(planned.corners, planned.labels, 1, origin);
    if (moving.valid()) add_gradient(planned, moving);
  }
}

VolumeChange::OfRegion& VolumeChange::at(Region region) {
  for (OfRegion& known : regions_)
    if (known.region == region) return known;
  regions_.push_back({region});
  return regions_.back();
}

void VolumeChange::add(const Corners& corners, Labels labels, double sign, const Vec3& origin) {
  const double volume = sign * (corners[0] - origin).dot((corners[1] - origin).cross(Vec3(corners[2] - origin))) / 6;
  at(labels.p).volume += volume;
  at(labels.q).volume -= volume;
}

void VolumeChange::add_gradient(const PlannedTriangle& planned, Vertex moving) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (planned.vertices[i] != moving) continue;
    const Vec3& here = planned.corners[i];
    const Vec3 gradient = (planned.corners[(i + 1) % 3] - here).cross(Vec3(planned.corners[(i + 2) % 3] - here)) / 6;
    at(planned.labels.p).gradient += gradient;
    at(planned.labels.q).gradient -= gradient;
  }
}

double VolumeChange::largest() const {
  double largest = 0;
  for (const OfRegion& r : regions_) largest = std::max(largest, std::abs(r.volume));
  return largest;
}

Vec3 VolumeChange::restoring_shift(Hold hold) const {
  constexpr double negligible = 0.01;
  Eigen::Matrix3d quadric = Eigen::Matrix3d::Zero();
  Vec3 wanted = Vec3::Zero();
  for (const OfRegion& r : regions_) {
    const Vec3 gradient = free_part(hold, r.gradient);
    quadric += gradient * gradient.transpose();
    wanted -= r.volume * gradient;
  }
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> modes;
  modes.computeDirect(quadric);
  const double largest = modes.eigenvalues()[2];
  Vec3 shift = Vec3::Zero();
  for (int i = 0; i < 3; ++i) {
    const double eigenvalue = modes.eigenvalues()[i];
    if (!(eigenvalue > negligible * largest)) continue;
    const Vec3 mode = modes.eigenvectors().col(i);
    shift += mode.dot(wanted) / eigenvalue * mode;
  }
  return free_part(hold, shift);  // to the bit
}

bool keeps_volumes(const ChangePlan& plan, const Limits& limits) {
  return plan.volume_change <= limits.max_volume_change;
}

}  // namespace lostopos
