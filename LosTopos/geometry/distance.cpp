#include "LosTopos/geometry/distance.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace lostopos {
namespace {

// Sizes between these allow products of four lengths without overflow or a harmful underflow.
constexpr double smallest_plain_size = 0x1p-200;
constexpr double largest_plain_size = 0x1p+200;

// A solution inside the triangle, or of two lines, is trusted alone when sin^2 of the angle between the directions
// exceeds this; below, the boundary's candidates are looked at too and the closest of all is taken.
constexpr double well_conditioned = 1e-6;

double size_of(const Vec3& u, const Vec3& v, const Vec3& w) {
  return u.cwiseAbs().cwiseMax(v.cwiseAbs()).cwiseMax(w.cwiseAbs()).maxCoeff();
}

bool is_plain(double size) {
  return size >= smallest_plain_size && size <= largest_plain_size;
}

// A power of two that brings lengths of this size near one.
double scale_for(double size) {
  int exponent = 0;
  std::frexp(size, &exponent);
  return std::ldexp(1.0, std::clamp(-exponent, -1000, 1000));
}

// offset and distance of p against a + ab, with ap = p - a, for products that neither overflow nor underflow.
PointSegmentDistance plain_point_segment(const Vec3& ap, const Vec3& ab) {
  const double length_squared = ab.squaredNorm();
  PointSegmentDistance result;
  if (length_squared > 0) result.t = std::clamp(ap.dot(ab) / length_squared, 0.0, 1.0);
  result.offset = result.t == 1 ? Vec3(ap - ab) : Vec3(ap - result.t * ab);
  result.distance = result.offset.norm();
  return result;
}

// Keeps the closer of the present answer and a point of the edge from corner i to corner j.
void take_closer(PointTriangleDistance& best, const PointSegmentDistance& edge, int i, int j) {
  if (edge.distance >= best.distance) return;
  best.distance = edge.distance;
  best.offset = edge.offset;
  best.weights.setZero();
  best.weights[i] = 1 - edge.t;
  best.weights[j] = edge.t;
}

PointTriangleDistance plain_point_triangle(const Vec3& ap, const Vec3& ab, const Vec3& ac) {
  const Vec3 n = ab.cross(ac);
  const double nn = n.squaredNorm();
  const double b_share = ap.cross(ac).dot(n);
  const double c_share = ab.cross(ap).dot(n);
  PointTriangleDistance best;
  best.distance = HUGE_VAL;
  if (nn > 0 && b_share >= 0 && c_share >= 0 && b_share + c_share <= nn) {
    best.weights[1] = b_share / nn;
    best.weights[2] = std::min(c_share / nn, 1 - best.weights[1]);
    best.weights[0] = std::max(0.0, 1 - best.weights[1] - best.weights[2]);
    best.offset = ap - best.weights[1] * ab - best.weights[2] * ac;
    best.distance = best.offset.norm();
    if (nn > well_conditioned * ab.squaredNorm() * ac.squaredNorm()) return best;
  }
  take_closer(best, plain_point_segment(ap, ab), 0, 1);
  take_closer(best, plain_point_segment(ap, ac), 0, 2);
  take_closer(best, plain_point_segment(ap - ab, ac - ab), 1, 2);
  return best;
}

void take_closer(SegmentSegmentDistance& best, double s, double t, const Vec3& offset) {
  const double distance = offset.norm();
  if (distance < best.distance) best = {distance, s, t, offset};
}

// Segments p0 + s u and q0 + t v with w = p0 - q0.
SegmentSegmentDistance plain_segment_segment(const Vec3& u, const Vec3& v, const Vec3& w) {
  SegmentSegmentDistance best;
  best.distance = HUGE_VAL;
  const Vec3 n = u.cross(v);
  const double nn = n.squaredNorm();
  const double s_share = v.cross(w).dot(n);
  const double t_share = u.cross(w).dot(n);
  if (nn > 0 && s_share >= 0 && s_share <= nn && t_share >= 0 && t_share <= nn) {
    const double s = s_share / nn;
    const double t = t_share / nn;
    take_closer(best, s, t, w + s * u - t * v);
    if (nn > well_conditioned * u.squaredNorm() * v.squaredNorm()) return best;
  }
  const PointSegmentDistance p0 = plain_point_segment(w, v);
  take_closer(best, 0, p0.t, p0.offset);
  const PointSegmentDistance p1 = plain_point_segment(w + u, v);
  take_closer(best, 1, p1.t, p1.offset);
  const PointSegmentDistance q0 = plain_point_segment(-w, u);
  take_closer(best, q0.t, 0, -q0.offset);
  const PointSegmentDistance q1 = plain_point_segment(v - w, u);
  take_closer(best, q1.t, 1, -q1.offset);
  return best;
}

template <class Result>
Result unscaled(Result result, double scale) {
  result.distance /= scale;
  result.offset /= scale;
  return result;
}

}  // namespace

PointSegmentDistance point_segment_distance(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 ap = p - a;
  const Vec3 ab = b - a;
  const double size = size_of(ap, ab, ab);
  if (is_plain(size)) return plain_point_segment(ap, ab);
  if (size == 0) return {};
  const double k = scale_for(size);
  return unscaled(plain_point_segment(k * ap, k * ab), k);
}

PointTriangleDistance point_triangle_distance(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ap = p - a;
  const Vec3 ab = b - a;
  const Vec3 ac = c - a;
  const double size = size_of(ap, ab, ac);
  if (is_plain(size)) return plain_point_triangle(ap, ab, ac);
  if (size == 0) return {};
  const double k = scale_for(size);
  return unscaled(plain_point_triangle(k * ap, k * ab, k * ac), k);
}

SegmentSegmentDistance segment_segment_distance(const Vec3& p0, const Vec3& p1, const Vec3& q0, const Vec3& q1) {
  const Vec3 u = p1 - p0;
  const Vec3 v = q1 - q0;
  const Vec3 w = p0 - q0;
  const double size = size_of(u, v, w);
  if (is_plain(size)) return plain_segment_segment(u, v, w);
  if (size == 0) return {};
  const double k = scale_for(size);
  return unscaled(plain_segment_segment(k * u, k * v, k * w), k);
}

}  // namespace lostopos
