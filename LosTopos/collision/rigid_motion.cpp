#include "LosTopos/collision/rigid_motion.h"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <vector>

namespace lostopos {
namespace {

constexpr double least_spread = 1e-6;       // of the second direction over the first, for a rotation to be determined
constexpr double least_rotation_trace = 2;  // 1 + 2 cos 60°

using Mat3 = Eigen::Matrix3d;

struct RigidMotion {
  Vec3 centre, translation;
  Mat3 rotation;
};

Mat3 best_rotation(const Mat3& covariance) {
  const Eigen::JacobiSVD<Mat3> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Vec3& spread = svd.singularValues();
  if (!(spread[1] > least_spread * spread[0])) return Mat3::Identity();
  const double handedness = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0 ? -1 : 1;
  const Mat3 rotation = svd.matrixV() * Vec3(1, 1, handedness).asDiagonal() * svd.matrixU().transpose();
  return rotation.trace() > least_rotation_trace ? rotation : Mat3(Mat3::Identity());
}

RigidMotion fit(const Motion& motion, std::span<const Vertex> vertices) {
  // Relative to one of them: a distant origin costs no digits.
  const Vec3 origin = motion.starts()[vertices.front().index()];
  RigidMotion result;
  result.centre.setZero();
  result.translation.setZero();
  for (Vertex v : vertices) {
    result.centre += motion.starts()[v.index()] - origin;
    result.translation += motion.asked(v) - motion.starts()[v.index()];
  }
  const double count = static_cast<double>(vertices.size());
  result.centre = origin + result.centre / count;
  result.translation /= count;
  Mat3 covariance = Mat3::Zero();
  for (Vertex v : vertices) {
    const Vec3 arm = motion.starts()[v.index()] - result.centre;
    covariance += arm * (motion.asked(v) - result.centre - result.translation).transpose();
  }
  result.rotation = best_rotation(covariance);
  return result;
}

// A body with vertices that slide goes where their held coordinates are asked to go, and does not turn.
void follow_held_coordinates(const Motion& motion, std::span<const Vertex> zone, RigidMotion& body) {
  Vec3 sum = Vec3::Zero(), count = Vec3::Zero();
  for (Vertex v : zone) {
    for (int i = 0; i < 3; ++i) {
      if (!holds(motion.hold(v), i)) continue;
      sum[i] += motion.asked(v)[i] - motion.starts()[v.index()][i];
      count[i] += 1;
    }
  }
  if (count.isZero(0)) return;
  body.rotation = Mat3::Identity();
  for (int i = 0; i < 3; ++i)
    if (count[i] > 0) body.translation[i] = sum[i] / count[i];
}

}  // namespace

void move_rigidly(Motion& motion, std::span<const Vertex> zone) {
  std::vector<Vertex> leaders;
  for (Vertex v : zone) {
    if (motion.held(v)) leaders.push_back(v);
  }
  RigidMotion body = leaders.empty() ? fit(motion, zone) : fit(motion, leaders);
  if (leaders.empty()) follow_held_coordinates(motion, zone, body);
  for (Vertex v : zone) {
    if (motion.held(v)) continue;
    const Vec3& start = motion.starts()[v.index()];
    const Vec3 arm = start - body.centre;
    motion.set_end(v, start + (body.translation + (body.rotation * arm - arm)));
  }
}

}  // namespace lostopos
