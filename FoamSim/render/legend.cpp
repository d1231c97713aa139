#include "FoamSim/render/legend.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "FoamSim/render/text.h"
#include "FoamSim/render/tone.h"

namespace foamsim::render {
namespace {

Pixel ink(Background background) {
  return background == Background::dark ? Pixel{230, 236, 242, 255} : Pixel{30, 34, 40, 255};
}

// Pixels a dot of a letter: a line takes about a twentieth of the picture's height.
int text_scale(const Image& image) {
  return std::max(1, image.height() / 200);
}

std::string short_number(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3g", value);
  return text.data();
}

// The largest of 1, 2 and 5 times a power of ten that is not above `most`.
double round_length(double most) {
  const double power = std::pow(10, std::floor(std::log10(most)));
  for (const double digit : {5.0, 2.0})
    if (digit * power <= most) return digit * power;
  return power;
}

}  // namespace

void draw_legend(Image& image, const std::string& name, const FieldRange& range, Background background) {
  const int scale = text_scale(image), line = (letter_height + 3) * scale, margin = 3 * scale;
  const int width = 4 * scale, height = image.height() / 2, top = (image.height() - height) / 2;
  const std::string low = short_number(range.low), high = short_number(range.high);
  const int right = image.width() - margin;
  if (height < 3 * line || right < text_width(name, scale) + width) return;
  const Pixel color = ink(background);
  for (int y = 0; y < height; ++y) {
    const double part = 1 - y / static_cast<double>(height - 1);
    const auto shown = field_color(range.low + part * (range.high - range.low), range);
    draw_rectangle(image, right - width, top + y, width, 1,
                   {encode_srgb(shown.x()), encode_srgb(shown.y()), encode_srgb(shown.z()), 255});
  }
  const auto write = [&](const std::string& text, int end, int y) {
    draw_text(image, end - text_width(text, scale), y, text, scale, color);
  };
  write(name, right, top - line);
  write(high, right - width - 2 * scale, top);
  write(low, right - width - 2 * scale, top + height - letter_height * scale);
}

void draw_scale_bar(Image& image, const Camera& camera, const std::string& unit, Background background) {
  const double pixels_a_length = image.height() / (2 * camera_axes(camera).half_height);
  const double length = round_length(0.25 * image.width() / pixels_a_length);
  const int scale = text_scale(image), margin = 4 * scale;
  const int bottom = image.height() - margin - (letter_height + 2) * scale;
  const int width = static_cast<int>(std::lround(length * pixels_a_length));
  const Pixel color = ink(background);
  draw_rectangle(image, margin, bottom - scale, width, scale, color);
  for (const int end : {margin, margin + width - scale})
    draw_rectangle(image, end, bottom - 3 * scale, scale, 3 * scale, color);
  draw_text(image, margin, bottom + 2 * scale, short_number(length) + " " + unit, scale, color);
}

void draw_label(Image& image, const std::string& text, Background background) {
  const int scale = text_scale(image);
  draw_text(image, 4 * scale, 4 * scale, text, scale, ink(background));
}

}  // namespace foamsim::render
