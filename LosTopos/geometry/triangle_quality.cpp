#include "LosTopos/geometry/triangle_quality.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace lostopos {
namespace {

// The vector over its largest component, so that products of such vectors neither overflow nor underflow.
Vec3 scaled_to_one(const Vec3& v) {
  const double size = v.lpNorm<Eigen::Infinity>();
  return size > 0 ? Vec3(v / size) : v;
}

// The angle between two vectors of any length.
double angle_between(const Vec3& u, const Vec3& v) {
  const Vec3 a = scaled_to_one(u);
  const Vec3 b = scaled_to_one(v);
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

}  // namespace

double triangle_area(const Vec3& a, const Vec3& b, const Vec3& c) {
  return 0.5 * (b - a).cross(c - a).norm();
}

Vec3 triangle_normal(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 n = scaled_to_one(scaled_to_one(b - a).cross(scaled_to_one(c - a)));
  const double length = n.norm();
  return length > 0 ? Vec3(n / length) : Vec3::Zero();
}

double corner_angle(const Vec3& corner, const Vec3& p, const Vec3& q) {
  return angle_between(p - corner, q - corner);
}

Vec3 triangle_angles(const Vec3& a, const Vec3& b, const Vec3& c) {
  return {corner_angle(a, b, c), corner_angle(b, c, a), corner_angle(c, a, b)};
}

double min_angle(const Vec3& a, const Vec3& b, const Vec3& c) {
  return triangle_angles(a, b, c).minCoeff();
}

double max_angle(const Vec3& a, const Vec3& b, const Vec3& c) {
  return triangle_angles(a, b, c).maxCoeff();
}

double aspect_ratio(const Vec3& a, const Vec3& b, const Vec3& c) {
  // The shortest altitude stands on the longest edge: longest / altitude = longest^2 / (2 area).
  const double size = std::max(
      {(b - a).lpNorm<Eigen::Infinity>(), (c - b).lpNorm<Eigen::Infinity>(), (a - c).lpNorm<Eigen::Infinity>()});
  if (!(size > 0)) return std::numeric_limits<double>::infinity();
  const Vec3 ab = (b - a) / size;
  const Vec3 bc = (c - b) / size;
  const Vec3 ca = (a - c) / size;
  const double longest_squared = std::max({ab.squaredNorm(), bc.squaredNorm(), ca.squaredNorm()});
  const double twice_area = ab.cross(ca).norm();
  return std::numbers::sqrt3 / 2 * longest_squared / twice_area;
}

double dihedral_angle(const Vec3& e0, const Vec3& e1, const Vec3& a, const Vec3& b) {
  const Vec3 edge = scaled_to_one(e1 - e0);
  const double length = edge.norm();
  if (!(length > 0)) return 0;
  const Vec3 axis = edge / length;
  const Vec3 normal_a = scaled_to_one(axis.cross(scaled_to_one(a - e0)));
  const Vec3 normal_b = scaled_to_one(axis.cross(scaled_to_one(b - e0)));
  return std::atan2(axis.dot(normal_a.cross(normal_b)), normal_a.dot(normal_b));
}

}  // namespace lostopos
