#include "FoamSim/render/tone.h"

#include <algorithm>
#include <cmath>

namespace foamsim::render {

float ToneCurve::operator()(float x) const {
  if (!(x > knee)) return std::max(x, 0.0f);
  if (x >= white) return 1;
  // y = knee + (1 − knee)(1 − (1 − s)^p), s = (x − knee)/(white − knee); p makes the slope 1 at the knee.
  const float s = (x - knee) / (white - knee);
  const float p = (white - knee) / (1 - knee);
  return knee + (1 - knee) * (1 - std::pow(1 - s, p));
}

std::uint8_t encode_srgb(float linear) {
  const float x = std::clamp(linear, 0.0f, 1.0f);
  const float y = x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1 / 2.4f) - 0.055f;
  return static_cast<std::uint8_t>(std::lround(255 * y));
}

std::array<std::uint8_t, 4> encode_opaque(const Eigen::Vector3f& linear, const ToneCurve& tone) {
  return {encode_srgb(tone(linear.x())), encode_srgb(tone(linear.y())), encode_srgb(tone(linear.z())), 255};
}

std::array<std::uint8_t, 4> encode_alpha(const Eigen::Vector3f& premultiplied, float alpha, const ToneCurve& tone) {
  const Eigen::Vector3f shown(tone(premultiplied.x()), tone(premultiplied.y()), tone(premultiplied.z()));
  const float a = std::clamp(std::max(alpha, shown.mean()), 0.0f, 1.0f);
  if (!(a > 0)) return {0, 0, 0, 0};
  return {encode_srgb(shown.x() / a), encode_srgb(shown.y() / a), encode_srgb(shown.z() / a),
          static_cast<std::uint8_t>(std::lround(255 * a))};
}

}  // namespace foamsim::render
