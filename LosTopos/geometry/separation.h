#pragma once

#include <array>

#include "LosTopos/geometry/moving_hull.h"

namespace lostopos {

// Certificates that a moving hull stays away from the origin. All are rigorous: forward bounds of every rounding and
// underflow are taken off before a sign counts. Each function returns the end of a stretch [t, end] without contact: t
// (or less) when it certifies nothing, 1 exactly when the stretch reaches the end of the motion.

/// As long as n . corner, linear in time, is positive for every corner. Any n with components of size near one.
double advance_by_fixed_plane(const MovingHull& hull, const Vec3& n, double t);

/// As long as n . corner, quadratic in time, is positive for every corner. Any n with components of size near one.
double advance_by_turning_plane(const MovingHull& hull, const MovingVector& n, double t);

/// The volume spanned by the first corner, e1 and e2, a cubic in time: while it is not zero the shapes are not coplanar
/// and so do not meet.
class CoplanarityCubic {
 public:
  explicit CoplanarityCubic(const MovingHull& hull);

  double advance(double t) const;

  /// 1 or -1; means nothing near a root.
  double sign_at(double t) const { return polar_value(t, t, t) < 0 ? -1 : 1; }

 private:
  // The symmetric function, linear in each argument, that is the cubic for equal ones; on (low, low, low) ... (high,
  // high, high) it is the Bernstein coefficients on [low, high].
  double polar_value(double t0, double t1, double t2) const;

  // The end of a stretch [low, end], not past high, without a root.
  double clip(double low, double high) const;

  std::array<double, 4> b_;  // Bernstein coefficients on [0, 1]
  double error_;
};

}  // namespace lostopos
