#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

namespace foamsim::render {

/// Maps linear light to display: the identity up to `knee`, then a smooth shoulder that reaches 1 at `white`.
struct ToneCurve {
  float knee = 0.6f;
  float white = 4.0f;

  float operator()(float x) const;
};

/// sRGB encoding (IEC 61966-2-1) of a linear value, clamped to [0, 1] and rounded to 8 bits.
std::uint8_t encode_srgb(float linear);

/// Encodes an opaque colour.
std::array<std::uint8_t, 4> encode_opaque(const Eigen::Vector3f& linear, const ToneCurve& tone);

/// Encodes a colour premultiplied by its opacity. The opacity is raised where needed to keep highlights that are
/// brighter than an opaque surface would allow.
std::array<std::uint8_t, 4> encode_alpha(const Eigen::Vector3f& premultiplied, float alpha, const ToneCurve& tone);

}  // namespace foamsim::render
