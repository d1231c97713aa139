#include "LosTopos/geometry/separation.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cfloat>
#include <cmath>

namespace lostopos {
namespace {

constexpr double u = DBL_EPSILON / 2;  // unit roundoff

// Covers every underflow: each loses at most 2^-1075, is multiplied by at most the square of the largest component
// allowed, 2^20, and there are under 100.
constexpr double underflow_bound = DBL_MIN;

// n . corner has errors of at most 5 u sum |n_k| |corner_k| (one rounding in the corner, three in products and sums);
// 8 covers the rounding of the bound and its subtraction too.
constexpr double linear_error = 8 * u;

// The same for a Bernstein coefficient of the quadratic, the mean of two such, and 7 u for two levels of de Casteljau's
// scheme; 24 leaves room.
constexpr double quadratic_error = 24 * u;

// A Bernstein coefficient of the cubic: 11 u of the permanent (three differences, a sum of cross products, a sum of
// dot products over 3), 10 u for three levels of de Casteljau's scheme, 7 u for the permanent and the subtraction of
// the bound; 40 leaves room.
constexpr double cubic_error = 40 * u;

// Factors for times: quotients of bounds are off by 3 u; times on a stretch, computed from them, by up to 20 u.
constexpr double before = 1 - 8 * u;
constexpr double well_before = 1 - 32 * u;
constexpr double after = 1 + 8 * u;

// Steps of clipping towards the next root of the cubic.
constexpr int max_clips = 16;

double dot(const Vec3& a, const Vec3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vec3 magnitude(const MovingVector& v) {
  return v.start.cwiseAbs().cwiseMax(v.end.cwiseAbs());
}

double permanent(const Vec3& x, const Vec3& y, const Vec3& z) {
  return x[0] * (y[1] * z[2] + y[2] * z[1]) + x[1] * (y[2] * z[0] + y[0] * z[2]) + x[2] * (y[0] * z[1] + y[1] * z[0]);
}

// A time not after the first one in [t, 1] at which the quadratic with Bernstein coefficients a, b, c on [t, 1], a > 0,
// is not positive; 1 when there is none. The coefficients count as exact.
double quadratic_advance(double a, double b, double c, double t) {
  const double bb = b * b;
  const double ac = a * c;
  if (c > 0 && (b >= 0 || bb * after < ac)) return 1;
  // With x = s / (1 - s) the roots are those of c x^2 + 2 b x + a. Each form of the smallest positive one is free of
  // cancellation but for the discriminant's, which is taken from above where it matters.
  double s = 0;
  if (b <= 0) {
    const double root = std::sqrt(std::max(0.0, bb - ac) + 8 * u * (bb + std::abs(ac)) + underflow_bound);
    s = a / (a + (root - b));
  } else {
    const double root = std::sqrt(bb - ac);  // c <= 0
    s = (b + root) / ((b + root) - c);
  }
  return (t + (1 - t) * (s * well_before)) * well_before;
}

}  // namespace

double advance_by_fixed_plane(const MovingHull& hull, const Vec3& n, double t) {
  const Vec3 n_size = n.cwiseAbs();
  double end = 1;
  for (std::size_t i = 0; i < static_cast<std::size_t>(hull.size); ++i) {
    const MovingVector& corner = hull.corners[i];
    // (1 - t) a + t b is a lower bound of n . corner(t).
    const double a = dot(n, corner.start) - (linear_error * dot(n_size, corner.start.cwiseAbs()) + underflow_bound);
    const double b = dot(n, corner.end) - (linear_error * dot(n_size, corner.end.cwiseAbs()) + underflow_bound);
    if (a > 0 && b > 0) continue;
    if (a > 0) {
      end = std::min(end, a / (a - b) * before);
    } else if (!(b > 0) || !(-a / (b - a) * after < t)) {
      return t;
    }
  }
  return end;
}

double advance_by_turning_plane(const MovingHull& hull, const MovingVector& n, double t) {
  const Vec3 n_size = magnitude(n);
  const double r = 1 - t;
  double end = 1;
  for (std::size_t i = 0; i < static_cast<std::size_t>(hull.size); ++i) {
    const MovingVector& corner = hull.corners[i];
    const double error = quadratic_error * dot(n_size, magnitude(corner)) + underflow_bound;
    const double q0 = dot(n.start, corner.start);
    const double q1 = 0.5 * (dot(n.start, corner.end) + dot(n.end, corner.start));
    const double q2 = dot(n.end, corner.end);
    const double q12 = r * q1 + t * q2;
    const double a = r * (r * q0 + t * q1) + t * q12 - error;
    if (!(a > 0)) return t;
    end = std::min(end, quadratic_advance(a, q12 - error, q2 - error, t));
  }
  return end;
}

CoplanarityCubic::CoplanarityCubic(const MovingHull& hull) {
  const MovingVector& w = hull.corners[0];
  const Vec3 n0 = hull.e1.start.cross(hull.e2.start);
  const Vec3 n1 = hull.e1.start.cross(hull.e2.end) + hull.e1.end.cross(hull.e2.start);  // twice the middle coefficient
  const Vec3 n2 = hull.e1.end.cross(hull.e2.end);
  b_ = {dot(w.start, n0), (dot(w.end, n0) + dot(w.start, n1)) / 3, (dot(w.end, n1) + dot(w.start, n2)) / 3,
        dot(w.end, n2)};
  error_ = cubic_error * permanent(magnitude(w), magnitude(hull.e1), magnitude(hull.e2)) + underflow_bound;
}

double CoplanarityCubic::polar_value(double t0, double t1, double t2) const {
  const double b01 = (1 - t0) * b_[0] + t0 * b_[1];
  const double b12 = (1 - t0) * b_[1] + t0 * b_[2];
  const double b23 = (1 - t0) * b_[2] + t0 * b_[3];
  const double b012 = (1 - t1) * b01 + t1 * b12;
  const double b123 = (1 - t1) * b12 + t1 * b23;
  return (1 - t2) * b012 + t2 * b123;
}

double CoplanarityCubic::clip(double low, double high) const {
  const double value = polar_value(low, low, low);
  const double sign = value < 0 ? -1 : 1;
  const double first = sign * value - error_;
  if (!(first > 0)) return low;
  const std::array<double, 3> others = {sign * polar_value(low, low, high) - error_,
                                        sign * polar_value(low, high, high) - error_,
                                        sign * polar_value(high, high, high) - error_};
  if (others[0] > 0 && others[1] > 0 && others[2] > 0) return high;
  // The graph lies in the hull of the points (i / 3, b[i]), and that above the steepest line down from the first.
  const double descent = std::max({(first - others[0]) * 3, (first - others[1]) * 1.5, first - others[2]});
  return std::min(high, (low + (high - low) * (first / descent * well_before)) * well_before);
}

double CoplanarityCubic::advance(double t) const {
  double low = t;
  double high = 1;
  for (int i = 0; i < max_clips; ++i) {
    const double end = clip(low, high);
    if (end == 1) return 1;
    if (!(end > low)) break;
    const double length = high - low;
    const bool poor = end - low < 0.5 * length;
    low = end;
    // A clipped stretch that is mostly lost calls for a shorter one, a certified stretch for a longer one.
    if (low == high) {
      high = std::min(1.0, low + 2 * length);
    } else if (poor) {
      high = low + 0.5 * (high - low);
    }
  }
  return low;
}

}  // namespace lostopos
