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
  static constexpr int tile_size = 64;
  static constexpr int few_samples = 4;

  // The pixels of a tile and of a margin around it, which say where more samples are needed.
  class Pixels {
   public:
    Pixels(int width, int height, int margin)
        : margin_(margin),
          stride_(width + 2 * margin),
          pixels_(static_cast<std::size_t>(stride_) * static_cast<std::size_t>(height + 2 * margin)) {}
    Samples& at(int x, int y) { return pixels_[place(x, y)]; }
    const Samples& at(int x, int y) const { return pixels_[place(x, y)]; }

   private:
    std::size_t place(int x, int y) const {
      return static_cast<std::size_t>(y + margin_) * static_cast<std::size_t>(stride_) +
             static_cast<std::size_t>(x + margin_);
    }
    int margin_, stride_;
    std::vector<Samples> pixels_;
  };

  // In rounds: the middle of each pixel, a few samples instead where the pixels around differ from it, and the others
  // where these do. A line that is thinner than a pixel can run between all middles: then there are a few from the
  // start.
  void draw_tile(int left, int top) {
    const int width = std::min(tile_size, options_.width - left), height = std::min(tile_size, options_.height - top);
    const int few = std::min(few_samples, options_.samples);
    const bool begin_with_one = few > 1 && shader_.thinnest_line() > pixel_;
    const bool more = few < options_.samples;
    const int margin = (begin_with_one ? 1 : 0) + (more ? 1 : 0);
    Pixels pixels(width, height, margin);
    Shader::Scratch scratch;
    const auto in_margin = [&](int m, const auto& act) {
      for (int y = -m; y < height + m; ++y)
        for (int x = -m; x < width + m; ++x) act(x, y);
    };
    if (begin_with_one) {
      in_margin(margin, [&](int x, int y) { sample_middle(left + x, top + y, scratch, pixels.at(x, y)); });
      refine(pixels, in_margin, margin - 1, barely_visible, [&](int x, int y) {
        pixels.at(x, y) = {};
        sample(left + x, top + y, 0, few, scratch, pixels.at(x, y));
      });
    } else {
      in_margin(margin, [&](int x, int y) { sample(left + x, top + y, 0, few, scratch, pixels.at(x, y)); });
    }
    if (more)
      refine(pixels, in_margin, 0, visible, [&](int x, int y) {
        Samples& pixel = pixels.at(x, y);
        if (pixel.count == 1) pixel = {};
        sample(left + x, top + y, pixel.count, options_.samples, scratch, pixel);
      });
    in_margin(0, [&](int x, int y) { image_.at(left + x, top + y) = encoded(pixels.at(x, y)); });
  }

  // Samples again where a pixel's samples, or those of the pixels around it, differ by more than `most`.
  template <class InMargin, class Again>
  static void refine(const Pixels& pixels, const InMargin& in_margin, int margin, float most, const Again& again) {
    std::vector<std::pair<int, int>> chosen;
    in_margin(margin, [&](int x, int y) {
      bool differ = differs(pixels.at(x, y), most);
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) differ = differ || differs(pixels.at(x, y), pixels.at(x + dx, y + dy), most);
      if (differ) chosen.emplace_back(x, y);
    });
    for (const auto& [x, y] : chosen) again(x, y);
  }

  // By what can be seen of a staircase, 1/16 of the way from black to white; and by half of it, where a pixel has its
  // middle's light alone.
  static constexpr float visible = 0.06f, barely_visible = 0.03f;
  static bool differs(const Samples& s, float most) {
    return s.lightest - s.darkest > most || s.densest - s.clearest > most;
  }
  static bool differs(const Samples& a, const Samples& b, float most) {
    const auto shown = [](const Samples& s) { return std::sqrt(std::clamp(s.mean().mean(), 0.0f, 1.0f)); };
    return std::abs(shown(a) - shown(b)) > most || std::abs(a.mean_alpha() - b.mean_alpha()) > most;
  }

  void sample_middle(int x, int y, Shader::Scratch& scratch, Samples& samples) const {
    add_sample(x, y, Vector2f::Zero(), scratch, samples);
  }

  void sample(int x, int y, int begin, int end, Shader::Scratch& scratch, Samples& samples) const {
    const auto seed =
        static_cast<std::uint32_t>(y) * static_cast<std::uint32_t>(options_.width) + static_cast<std::uint32_t>(x);
    for (int s = begin; s < end; ++s) add_sample(x, y, sample_offset(seed, s), scratch, samples);
  }

  void add_sample(int x, int y, const Vector2f& offset, Shader::Scratch& scratch, Samples& samples) const {
    const Vector2f place(pixel_ * (static_cast<float>(x) + 0.5f + offset.x()) - pixel_ * 0.5f * options_.width,
                         1 - pixel_ * (static_cast<float>(y) + 0.5f + offset.y()));
    const Light light = shader_.eye_light(eye_ray(place), scratch);
    const Vector3f total = light.added + light.transmitted.cwiseProduct(backdrop(place));
    // A sample brighter than white would spoil the smoothing of its pixel's edges.
    samples.add((static_cast<float>(options_.exposure) * total).cwiseMin(tone_.white), 1 - light.transmitted.mean());
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
