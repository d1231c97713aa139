#include "MultiTracker/flows/curl_noise.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <random>

namespace multitracker {

using lostopos::Vec3;

CurlNoiseFlow::CurlNoiseFlow(std::uint64_t seed, double speed, double wavelength) {
  std::mt19937_64 random(seed);
  const auto uniform = [&] { return std::ldexp(static_cast<double>(random() >> 11) + 0.5, -53); };
  const auto direction = [&] {
    const double z = 2 * uniform() - 1, angle = 2 * std::numbers::pi * uniform(), r = std::sqrt(1 - z * z);
    return Vec3(r * std::cos(angle), r * std::sin(angle), z);
  };
  double sum_of_squares = 0;
  for (Wave& wave : waves_) {
    wave.number = 2 * std::numbers::pi / (wavelength * (0.5 + 0.5 * uniform())) * direction();
    // The curl of p cos(k · x + φ) is (p × k) sin(k · x + φ).
    wave.amplitude = direction().cross(wave.number).normalized() * (0.5 + uniform());
    wave.phase = 2 * std::numbers::pi * uniform();
    sum_of_squares += wave.amplitude.squaredNorm() / 2;
  }
  for (Wave& wave : waves_) wave.amplitude *= speed / std::sqrt(sum_of_squares);
}

Vec3 CurlNoiseFlow::velocity(const Vec3& x, double /*time*/) const {
  Vec3 v = Vec3::Zero();
  for (const Wave& wave : waves_) v += std::sin(wave.number.dot(x) + wave.phase) * wave.amplitude;
  return v;
}

}  // namespace multitracker
