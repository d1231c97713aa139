#include "MultiTracker/flows/enright.h"

#include <cmath>
#include <numbers>

namespace multitracker {

lostopos::Vec3 EnrightFlow::velocity(const lostopos::Vec3& x, double time) const {
  constexpr double pi = std::numbers::pi;
  const lostopos::Vec3 s = (pi * x).array().sin(), s2 = (2 * pi * x).array().sin();
  const double sign = std::cos(pi * time / period());
  return sign * lostopos::Vec3(2 * s.x() * s.x() * s2.y() * s2.z(), -s2.x() * s.y() * s.y() * s2.z(),
                               -s2.x() * s2.y() * s.z() * s.z());
}

}  // namespace multitracker
