#include "FoamSim/render/thickness.h"

#include <algorithm>
#include <cmath>

namespace foamsim::render {
namespace {

using Eigen::Vector3f;

// A value in [−1, 1) from a number.
float signed_unit(std::uint32_t bits) {
  return static_cast<float>(bits >> 8) * 0x1p-23f - 1;
}

float lerp(float a, float b, float t) {
  return a + t * (b - a);
}

// Value noise with quintic fade, in [−1, 1], smooth to second order.
float noise(const Vector3f& x, std::uint32_t seed) {
  // Far outside the picture colours do not matter, but the conversion to int must stay defined.
  const Vector3f p = x.cwiseMax(-1e6f).cwiseMin(1e6f);
  const Vector3f base = p.array().floor();
  const Vector3f t = p - base;
  const Vector3f f = (t.array().cube() * (t.array() * (t.array() * 6 - 15) + 10)).matrix();
  // Every lattice point's value is a hash of its three indices, one index at a time.
  const auto index = [&base](int axis, int step) {
    return static_cast<std::uint32_t>(static_cast<int>(base[axis]) + step);
  };
  const auto along_x = [&](std::uint32_t yz) {
    return lerp(signed_unit(hash(index(0, 0) + yz)), signed_unit(hash(index(0, 1) + yz)), f.x());
  };
  const auto along_y = [&](std::uint32_t z) {
    return lerp(along_x(hash(index(1, 0) + z)), along_x(hash(index(1, 1) + z)), f.y());
  };
  return lerp(along_y(hash(index(2, 0) + seed)), along_y(hash(index(2, 1) + seed)), f.z());
}

}  // namespace

// Multiply and shift, with the constants of the low-bias search by C. Wellons (hash-prospector, public domain).
std::uint32_t hash(std::uint32_t x) {
  x = (x ^ (x >> 16)) * 0x7feb352du;
  x = (x ^ (x >> 15)) * 0x846ca68bu;
  return x ^ (x >> 16);
}

ThicknessField::ThicknessField(double mean, double variation, const Vector3f& up)
    : mean_(static_cast<float>(mean)), variation_(static_cast<float>(variation)), up_(up) {}

float ThicknessField::operator()(const Vector3f& x, std::uint32_t film) const {
  if (variation_ == 0) return mean_;
  const float height = std::clamp(x.dot(up_), -1.5f, 1.5f);
  // Swirls are wider than high: layers of equal thickness lie level in a draining film. One noise bends the next.
  const Vector3f level = 1.1f * x + 1.3f * x.dot(up_) * up_;
  const float bend = noise(level, film);
  const float swirl = noise(1.7f * level + Vector3f::Constant(1.4f * bend), film + 1);
  return mean_ * std::clamp(1 + variation_ * (-0.32f * height + 0.38f * swirl + 0.18f * bend), 0.0f, 2.0f);
}

}  // namespace foamsim::render
