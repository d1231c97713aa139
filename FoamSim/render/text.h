#pragma once

#include <string_view>

#include "FoamSim/render/image.h"

namespace foamsim::render {

/// Letters of five by seven dots, each `scale` pixels wide and high, six dots from one to the next.
inline constexpr int letter_width = 6, letter_height = 7;

/// The width of a text in pixels.
int text_width(std::string_view text, int scale);

/// Writes a text (ASCII; a question mark for what else there is) with its upper left corner at (x, y). What lies
/// outside of the picture is left out.
void draw_text(Image& image, int x, int y, std::string_view text, int scale, const Pixel& color);

/// Fills the pixels from (left, top) on, so many; what lies outside of the picture is left out.
void draw_rectangle(Image& image, int left, int top, int width, int height, const Pixel& color);

}  // namespace foamsim::render
