#include "FoamSim/render/render.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "Base/error.h"
#include "Base/parallel/for_each.h"
#include "FoamSim/render/shading.h"
#include "FoamSim/render/tone.h"

namespace foamsim::render {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;

void require(bool ok, const std::string& name, const std::string& range) {
  if (!ok) throw base::InputError("render options: " + name + " must be in " + range);
}

bool in(double x, double low, double high) {
  return x >= low && x <= high;
}

void check(const RenderOptions& o) {
  require(in(o.width, 1, 32768) && in(o.height, 1, 32768), "width and height", "1 ... 32768");
  require(in(o.samples, 1, 4096), "samples", "1 ... 4096");
  require(o.film_thickness > 0 && o.film_thickness <= 1500, "film_thickness", "(0, 1500] nm");
  require(in(o.thickness_variation, 0, 1), "thickness_variation", "[0, 1]");
  require(in(o.iridescence, 0, 1), "iridescence", "[0, 1]");
  require(in(o.film_density, 0, 100), "film_density", "[0, 100]");
  require(in(o.tube_radius, 0, 1), "tube_radius", "[0, 1]");
  require(in(o.wireframe_width, 0, 100), "wireframe_width", "[0, 100] pixels");
  require(o.exposure > 0 && o.exposure <= 1e6, "exposure", "(0, 1e6]");
}

float to_unit(std::uint32_t bits) {
  return static_cast<float>(bits >> 8) * 0x1p-24f;
}

std::uint32_t reverse_bits(std::uint32_t x) {
  x = (x << 16) | (x >> 16);
  x = ((x & 0x00ff00ffu) << 8) | ((x >> 8) & 0x00ff00ffu);
  x = ((x & 0x0f0f0f0fu) << 4) | ((x >> 4) & 0x0f0f0f0fu);
  x = ((x & 0x33333333u) << 2) | ((x >> 2) & 0x33333333u);
  return ((x & 0x55555555u) << 1) | ((x >> 1) & 0x55555555u);
}

// Inverse of the tent's distribution: maps [0, 1) to offsets in [−1, 1] as dense as a tent filter's weight, so that the
// plain mean of the samples is the filtered pixel (filter importance sampling; Ernst, Stamminger, Greiner 2006).
float tent(float u) {
  return u < 0.5f ? std::sqrt(2 * u) - 1 : 1 - std::sqrt(2 - 2 * u);
}

// Offset of a sample from the middle of its pixel: Hammersley points, shifted at random for each pixel.
Vector2f sample_offset(std::uint32_t pixel, int sample, int samples) {
  const std::uint32_t shift = hash(pixel);
  const float u = (static_cast<float>(sample) + 0.5f) / static_cast<float>(samples) + to_unit(shift);
  const float v = to_unit(reverse_bits(static_cast<std::uint32_t>(sample)) + hash(shift));
  return {tent(u - std::floor(u)), tent(v)};
}

class Picture {
 public:
  Picture(const Surface& surface, const Camera& camera, const RenderOptions& options)
      : options_(options),
        axes_(camera_axes(camera)),
        mesh_(prepare(surface, camera.target, axes_.half_height)),
        pixel_(2.0f / static_cast<float>(options.height)),
        distance_(static_cast<float>((camera.eye - camera.target).norm() / axes_.half_height)),
        shader_(mesh_, axes_, options, pixel_ / distance_),
        tone_(options.background == Background::white ? ToneCurve{1.0f, 1.0f} : ToneCurve{}),
        image_(options.width, options.height) {}

  Image draw() {
    constexpr int kTile = 16;
    const int across = (options_.width + kTile - 1) / kTile;
    const int down = (options_.height + kTile - 1) / kTile;
    base::parallel_for_each(static_cast<std::size_t>(across) * static_cast<std::size_t>(down), 1, [&](std::size_t i) {
      Shader::Scratch scratch;
      const int tile = static_cast<int>(i);
      const int left = tile % across * kTile;
      const int top = tile / across * kTile;
      for (int y = top; y < std::min(top + kTile, options_.height); ++y)
        for (int x = left; x < std::min(left + kTile, options_.width); ++x) image_.at(x, y) = pixel(x, y, scratch);
    });
    return std::move(image_);
  }

 private:
  Pixel pixel(int x, int y, Shader::Scratch& scratch) const {
    Vector3f added = Vector3f::Zero();
    float alpha = 0;
    const auto seed = static_cast<std::uint32_t>(y) * static_cast<std::uint32_t>(options_.width) + x;
    for (int s = 0; s < options_.samples; ++s) {
      const Vector2f offset = sample_offset(seed, s, options_.samples);
      const Vector2f place(pixel_ * (static_cast<float>(x) + 0.5f + offset.x()) - pixel_ * 0.5f * options_.width,
                           1 - pixel_ * (static_cast<float>(y) + 0.5f + offset.y()));
      const Light light = shader_.eye_light(eye_ray(place), scratch);
      const Vector3f total = light.added + light.transmitted.cwiseProduct(backdrop(place));
      // A sample brighter than white would spoil the smoothing of its pixel's edges.
      added += (static_cast<float>(options_.exposure) * total).cwiseMin(tone_.white);
      alpha += 1 - light.transmitted.mean();
    }
    added /= static_cast<float>(options_.samples);
    alpha /= static_cast<float>(options_.samples);
    return options_.background == Background::transparent ? encode_alpha(added, alpha, tone_)
                                                          : encode_opaque(added, tone_);
  }

  // `place`: in the plane through the target, in scene units.
  Ray eye_ray(const Vector2f& place) const {
    const Vector3f back = axes_.back.cast<float>();
    const Vector3f to = place.x() * axes_.right.cast<float>() + place.y() * axes_.up.cast<float>();
    return {distance_ * back, (to - distance_ * back).normalized()};
  }

  Vector3f backdrop(const Vector2f& place) const {
    switch (options_.background) {
      case Background::white:
        return Vector3f::Constant(static_cast<float>(1 / options_.exposure));
      case Background::transparent:
        return Vector3f::Zero();
      case Background::dark:
        break;
    }
    const Vector3f rim(0.012f, 0.016f, 0.024f);
    const Vector3f glow(0.060f, 0.078f, 0.105f);
    const float r2 = (place - Vector2f(0, -0.1f)).squaredNorm();
    return rim + glow * std::exp(-0.9f * r2);
  }

  const RenderOptions& options_;
  CameraAxes axes_;
  FilmMesh mesh_;
  float pixel_;     // scene units
  float distance_;  // of the eye from the target
  Shader shader_;
  ToneCurve tone_;
  Image image_;
};

}  // namespace

Image render(const Surface& surface, const Camera& camera, const RenderOptions& options) {
  check(options);
  return Picture(surface, camera, options).draw();
}

Image render(const Surface& surface, const RenderOptions& options) {
  check(options);
  FramingOptions framing_options;
  framing_options.aspect = static_cast<double>(options.width) / options.height;
  return render(surface, framing(surface, framing_options), options);
}

}  // namespace foamsim::render
