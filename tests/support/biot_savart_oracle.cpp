#include "tests/support/biot_savart_oracle.h"

#include <Eigen/Geometry>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace foamsim::test {
namespace {

OracleVelocity at(const VortexSources& s, const LongVec3& x, long double delta) {
  OracleVelocity result;
  for (std::size_t t = 0; t < s.size(); ++t) {
    const LongVec3 d = x - LongVec3(s.x[t], s.y[t], s.z[t]);
    if (d.isZero(0)) continue;
    const long double r = std::sqrt(d.squaredNorm() + delta * delta);
    const LongVec3 term = LongVec3(s.gx[t], s.gy[t], s.gz[t]).cross(d) / (r * r * r);
    result.velocity += term;
    result.term_sum += term.norm();
  }
  constexpr long double scale = std::numbers::inv_pi_v<long double> / 4;
  result.velocity *= scale;
  result.term_sum *= scale;
  return result;
}

}  // namespace

std::vector<OracleVelocity> biot_savart_oracle(const VortexSources& sources, std::span<const lostopos::Vec3> targets,
                                               double delta) {
  std::vector<OracleVelocity> result;
  result.reserve(targets.size());
  for (const lostopos::Vec3& x : targets) result.push_back(at(sources, x.cast<long double>(), delta));
  return result;
}

}  // namespace foamsim::test
