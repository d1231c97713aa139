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
  require(in(o.color_opacity, 0, 1) && o.color_opacity < 1, "color_opacity", "[0, 1)");
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

// The second coordinate of Sobol's sequence; with `reverse_bits` as the first, every 4, 16, 64, ... points from the
// start on are spread evenly.
std::uint32_t sobol(std::uint32_t i) {
  std::uint32_t result = 0;
  for (std::uint32_t direction = 1u << 31; i != 0; i >>= 1, direction ^= direction >> 1)
    if ((i & 1) != 0) result ^= direction;
  return result;
}

// Offset of a sample from the middle of its pixel, at random for each pixel (Kollig and Keller 2002).
Vector2f sample_offset(std::uint32_t pixel, int sample) {
  const std::uint32_t scramble = hash(pixel);
  const auto i = static_cast<std::uint32_t>(sample);
  return {tent(to_unit(reverse_bits(i) ^ scramble)), tent(to_unit(sobol(i) ^ hash(scramble)))};
}

// Samples of a pixel, summed.
struct Samples {
  Vector3f added = Vector3f::Zero();
  float alpha = 0;
  float darkest = 1, lightest = 0;  // as shown
  float clearest = 1, densest = 0;
  int count = 0;

  void add(const Vector3f& light, float opacity) {
    added += light;
    alpha += opacity;
    const float shown = std::sqrt(std::clamp(light.mean(), 0.0f, 1.0f));
    darkest = std::min(darkest, shown);
    lightest = std::max(lightest, shown);
    clearest = std::min(clearest, opacity);
    densest = std::max(densest, opacity);
    ++count;
  }
  Vector3f mean() const { return added / static_cast<float>(count); }
  float mean_alpha() const { return alpha / static_cast<float>(count); }
};

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
    const int across = (options_.width + tile_size - 1) / tile_size;
    const int down = (options_.height + tile_size - 1) / tile_size;
    base::parallel_for_each(static_cast<std::size_t>(across) * static_cast<std::size_t>(down), 1, [&](std::size_t i) {
      const int tile = static_cast<int>(i);
      draw_tile(tile % across * tile_size, tile / across * tile_size);
    });
    return std::move(image_);
  }

 private:
  static constexpr int tile_size = 32;
  static constexpr int few_samples = 4;

  // A few samples everywhere, and one pixel around the tile; the others where these differ.
  void draw_tile(int left, int top) {
    constexpr int stride = tile_size + 2;
    const int width = std::min(tile_size, options_.width - left), height = std::min(tile_size, options_.height - top);
    Shader::Scratch scratch;
    std::vector<Samples> first(static_cast<std::size_t>(stride) * stride);
    const auto at = [&first](int x, int y) -> Samples& {
      return first[static_cast<std::size_t>((y + 1) * stride + x + 1)];
    };
    const int few = std::min(few_samples, options_.samples);
    const int around = few < options_.samples ? 1 : 0;
    for (int y = -around; y < height + around; ++y)
      for (int x = -around; x < width + around; ++x) sample(left + x, top + y, 0, few, scratch, at(x, y));
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        Samples pixel = at(x, y);
        bool differ = differs(pixel);
        for (int dy = -around; dy <= around; ++dy)
          for (int dx = -around; dx <= around; ++dx) differ = differ || differs(pixel, at(x + dx, y + dy));
        if (differ) sample(left + x, top + y, few, options_.samples, scratch, pixel);
        image_.at(left + x, top + y) = encoded(pixel);
      }
  }

  // By what can be seen of a staircase: 1/16 of the way from black to white.
  static constexpr float visible = 0.06f;
  static bool differs(const Samples& s) { return s.lightest - s.darkest > visible || s.densest - s.clearest > visible; }
  static bool differs(const Samples& a, const Samples& b) {
    const auto shown = [](const Samples& s) { return std::sqrt(std::clamp(s.mean().mean(), 0.0f, 1.0f)); };
    return std::abs(shown(a) - shown(b)) > visible || std::abs(a.mean_alpha() - b.mean_alpha()) > visible;
  }

  void sample(int x, int y, int begin, int end, Shader::Scratch& scratch, Samples& samples) const {
    const auto seed =
        static_cast<std::uint32_t>(y) * static_cast<std::uint32_t>(options_.width) + static_cast<std::uint32_t>(x);
    for (int s = begin; s < end; ++s) {
      const Vector2f offset = sample_offset(seed, s);
      const Vector2f place(pixel_ * (static_cast<float>(x) + 0.5f + offset.x()) - pixel_ * 0.5f * options_.width,
                           1 - pixel_ * (static_cast<float>(y) + 0.5f + offset.y()));
      const Light light = shader_.eye_light(eye_ray(place), scratch);
      const Vector3f total = light.added + light.transmitted.cwiseProduct(backdrop(place));
      // A sample brighter than white would spoil the smoothing of its pixel's edges.
      samples.add((static_cast<float>(options_.exposure) * total).cwiseMin(tone_.white), 1 - light.transmitted.mean());
    }
  }

  Pixel encoded(const Samples& samples) const {
    return options_.background == Background::transparent ? encode_alpha(samples.mean(), samples.mean_alpha(), tone_)
                                                          : encode_opaque(samples.mean(), tone_);
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
