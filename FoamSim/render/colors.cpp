#include "FoamSim/render/colors.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "Base/error.h"

namespace foamsim::render {
namespace {

using Eigen::Vector3f;

Vector3f linear(const Vector3f& srgb) {
  return srgb.unaryExpr([](float x) { return x <= 0.04045f ? x / 12.92f : std::pow((x + 0.055f) / 1.055f, 2.4f); });
}

// One channel of a hue in turns, at full saturation.
float channel(float hue, float shift) {
  const float h = hue + shift;
  return std::clamp(std::abs((h - std::floor(h)) * 6 - 3) - 1, 0.0f, 1.0f);
}

}  // namespace

Vector3f region_color(std::int32_t region) {
  if (region == 0) return Vector3f::Constant(0.3f);
  constexpr float golden = 0.618034f;  // spreads any number of hues evenly
  const float hue = static_cast<float>(region) * golden - std::floor(static_cast<float>(region) * golden);
  const Vector3f pure(channel(hue, 0), channel(hue, 2.0f / 3), channel(hue, 1.0f / 3));
  return linear(0.15f * Vector3f::Ones() + 0.8f * pure);
}

void color_by_region(Surface& surface) {
  surface.colors.clear();
  for (const auto& [p, q] : surface.labels) {
    const Vector3f color = p == 0   ? region_color(q)
                           : q == 0 ? region_color(p)
                                    : Vector3f(0.5f * (region_color(p) + region_color(q)));
    surface.colors.push_back({color, color, color});
  }
}

Vector3f field_color(double value, const FieldRange& range) {
  if (!std::isfinite(value)) return Vector3f::Constant(0.2f);
  static const std::array<Vector3f, 9> places{
      Vector3f(0.267f, 0.005f, 0.329f), Vector3f(0.279f, 0.175f, 0.483f), Vector3f(0.230f, 0.322f, 0.546f),
      Vector3f(0.173f, 0.449f, 0.558f), Vector3f(0.128f, 0.567f, 0.551f), Vector3f(0.158f, 0.684f, 0.502f),
      Vector3f(0.369f, 0.789f, 0.383f), Vector3f(0.678f, 0.864f, 0.190f), Vector3f(0.993f, 0.906f, 0.144f)};
  const double part = std::clamp((value - range.low) / (range.high - range.low), 0.0, 1.0) * 8;
  const auto i = std::min<std::size_t>(static_cast<std::size_t>(part), 7);
  const auto t = static_cast<float>(part - static_cast<double>(i));
  return linear((1 - t) * places[i] + t * places[i + 1]);
}

void color_by_field(Surface& surface, std::span<const double> values, const FieldRange& range) {
  if (values.size() != 3 * surface.triangles.size())
    throw base::InputError("render: a field has to have three values a triangle");
  if (!std::isfinite(range.low) || !std::isfinite(range.high) || !(range.low < range.high))
    throw base::InputError("render: the range of a field has to be two finite numbers, the lower first");
  surface.colors.clear();
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    surface.colors.push_back({field_color(values[3 * t], range), field_color(values[3 * t + 1], range),
                              field_color(values[3 * t + 2], range)});
}

FieldRange range_of(std::span<const double> values) {
  FieldRange range{INFINITY, -INFINITY};
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    range.low = std::min(range.low, value);
    range.high = std::max(range.high, value);
  }
  if (!(range.low <= range.high)) return {};
  if (range.low < range.high) return range;
  const double little = range.low == 0 ? 1 : 1e-3 * std::abs(range.low);
  return {range.low - little, range.high + little};
}

}  // namespace foamsim::render
