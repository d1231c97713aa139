// The orientation predicates: filter, shortcuts for zero, exact integers.
#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cfloat>
#include <climits>
#include <cmath>
#include <cstdint>

#include "LosTopos/geometry/predicates.h"

namespace lostopos {
namespace {

namespace mp = boost::multiprecision;

// Wide enough for a 3 x 3 determinant of coordinates whose exponents differ by up to fixed_exponent_range, without a
// heap allocation; any other coordinates take the integers of unlimited width.
constexpr unsigned fixed_bits = 1024;
constexpr int fixed_exponent_range = 280;  // 3 (53 + 1 + 280) + 3 bits <= 1024
using FixedInt =
    mp::number<mp::cpp_int_backend<fixed_bits, fixed_bits, mp::signed_magnitude, mp::unchecked, void>, mp::et_off>;
using WideInt = mp::number<mp::cpp_int_backend<>, mp::et_off>;

constexpr double unit_roundoff = DBL_EPSILON / 2;

// The exponents of the non-zero coordinates, as of frexp.
struct ExponentRange {
  int low = INT_MAX;
  int high = INT_MIN;
};

template <std::size_t n>
ExponentRange exponent_range(const std::array<double, n>& coordinates) {
  ExponentRange range;
  for (const double x : coordinates) {
    if (x == 0) continue;
    int exponent = 0;
    std::frexp(x, &exponent);
    range.low = std::min(range.low, exponent);
    range.high = std::max(range.high, exponent);
  }
  return range;
}

// x / 2^(lowest exponent - 53), which is an integer for every coordinate of the range.
template <class Int>
Int scaled_integer(double x, const ExponentRange& range) {
  if (x == 0) return Int(0);
  int exponent = 0;
  const double mantissa = std::frexp(x, &exponent);
  Int value(static_cast<std::int64_t>(std::ldexp(mantissa, 53)));
  value <<= static_cast<unsigned>(exponent - range.low);
  return value;
}

template <class Int>
int exact_orient2d(const std::array<double, 6>& p, const ExponentRange& range) {
  std::array<Int, 6> q;
  for (std::size_t i = 0; i < 6; ++i) q[i] = scaled_integer<Int>(p[i], range);
  const Int ux = q[2] - q[0];
  const Int uy = q[3] - q[1];
  const Int vx = q[4] - q[0];
  const Int vy = q[5] - q[1];
  const Int left = ux * vy;
  const Int right = uy * vx;
  return left.compare(right);
}

template <class Int>
int exact_orient3d(const std::array<double, 12>& p, const ExponentRange& range) {
  std::array<Int, 12> q;
  for (std::size_t i = 0; i < 12; ++i) q[i] = scaled_integer<Int>(p[i], range);
  for (std::size_t i = 3; i < 12; ++i) q[i] -= q[i % 3];
  const Int nx = q[4] * q[8] - q[5] * q[7];
  const Int ny = q[5] * q[6] - q[3] * q[8];
  const Int nz = q[3] * q[7] - q[4] * q[6];
  const Int determinant = nx * q[9] + ny * q[10] + nz * q[11];
  return determinant.sign();
}

int sign_of(int comparison) {
  return (comparison > 0) - (comparison < 0);
}

}  // namespace

int orient2d(const Vec2& a, const Vec2& b, const Vec2& c) {
  const double ux = b.x() - a.x();
  const double uy = b.y() - a.y();
  const double vx = c.x() - a.x();
  const double vy = c.y() - a.y();
  const double left = ux * vy;
  const double right = uy * vx;
  const double determinant = left - right;
  // Shewchuk's bound (3 + 16 u) u, and DBL_MIN for any underflow (each loses at most 2^-1075). Overflow makes the
  // bound infinite or NaN and so falls through.
  const double bound = (3 + 16 * unit_roundoff) * unit_roundoff * (std::abs(left) + std::abs(right)) + DBL_MIN;
  if (determinant > bound) return 1;
  if (determinant < -bound) return -1;

  // A difference of doubles is zero only when they are equal, so these are exact.
  if ((ux == 0 && uy == 0) || (vx == 0 && vy == 0) || (ux == 0 && vx == 0) || (uy == 0 && vy == 0)) return 0;
  const std::array<double, 6> p = {a.x(), a.y(), b.x(), b.y(), c.x(), c.y()};
  const ExponentRange range = exponent_range(p);
  return sign_of(range.high - range.low <= fixed_exponent_range ? exact_orient2d<FixedInt>(p, range)
                                                                : exact_orient2d<WideInt>(p, range));
}

int orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 u = b - a;
  const Vec3 v = c - a;
  const Vec3 w = d - a;
  const double yz = u.y() * v.z();
  const double zy = u.z() * v.y();
  const double zx = u.z() * v.x();
  const double xz = u.x() * v.z();
  const double xy = u.x() * v.y();
  const double yx = u.y() * v.x();
  const double determinant = (yz - zy) * w.x() + (zx - xz) * w.y() + (xy - yx) * w.z();
  const double wx = std::abs(w.x());
  const double wy = std::abs(w.y());
  const double wz = std::abs(w.z());
  const double permanent =
      (std::abs(yz) + std::abs(zy)) * wx + (std::abs(zx) + std::abs(xz)) * wy + (std::abs(xy) + std::abs(yx)) * wz;
  // Shewchuk's bound (7 + 56 u) u; an underflow in a minor is magnified by the component of w that multiplies it.
  const double bound = (7 + 56 * unit_roundoff) * unit_roundoff * permanent + DBL_MIN * (wx + wy + wz + 1);
  if (determinant > bound) return 1;
  if (determinant < -bound) return -1;

  // A difference of doubles is zero only when they are equal, so these are exact.
  if (a == b || a == c || a == d || b == c || b == d || c == d) return 0;
  for (int i = 0; i < 3; ++i) {
    if (u[i] == 0 && v[i] == 0 && w[i] == 0) return 0;
  }
  std::array<double, 12> p = {};
  for (std::size_t i = 0; i < 3; ++i) {
    p[i] = a[static_cast<int>(i)];
    p[3 + i] = b[static_cast<int>(i)];
    p[6 + i] = c[static_cast<int>(i)];
    p[9 + i] = d[static_cast<int>(i)];
  }
  const ExponentRange range = exponent_range(p);
  return sign_of(range.high - range.low <= fixed_exponent_range ? exact_orient3d<FixedInt>(p, range)
                                                                : exact_orient3d<WideInt>(p, range));
}

}  // namespace lostopos
