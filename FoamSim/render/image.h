#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace foamsim::render {

/// One pixel: red, green, blue (sRGB-encoded), alpha (straight, not premultiplied; 255 is opaque).
using Pixel = std::array<std::uint8_t, 4>;

/// An 8-bit picture, rows from top to bottom.
class Image {
 public:
  Image() = default;
  /// A picture of one colour.
  /// @throws base::InputError  unless both sizes are in 1 … 65535.
  Image(int width, int height, Pixel fill = {0, 0, 0, 255});

  int width() const { return width_; }
  int height() const { return height_; }
  bool empty() const { return pixels_.empty(); }

  Pixel& at(int x, int y) { return pixels_[index(x, y)]; }
  const Pixel& at(int x, int y) const { return pixels_[index(x, y)]; }
  /// All pixels, row by row.
  const std::vector<Pixel>& pixels() const { return pixels_; }

  friend bool operator==(const Image&, const Image&) = default;

 private:
  std::size_t index(int x, int y) const { return static_cast<std::size_t>(y) * width_ + x; }

  int width_ = 0;
  int height_ = 0;
  std::vector<Pixel> pixels_;
};

}  // namespace foamsim::render
