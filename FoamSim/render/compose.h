#pragma once

#include <span>

#include "FoamSim/render/image.h"

namespace foamsim::render {

/// How pictures are laid out on a sheet.
struct GridOptions {
  /// Pictures a row; 0: all in one row.
  int columns = 0;
  /// Gap between neighbouring pictures, pixels.
  int gap = 8;
  /// Margin around the whole, pixels.
  int margin = 0;
  /// Colour of gaps, margin and missing pictures.
  Pixel fill = {255, 255, 255, 255};
};

/// Lays pictures out row by row. Every cell of a column has the column's largest width, every cell of a row the row's
/// largest height; a smaller picture is centred in its cell. An empty `Image` leaves its cell blank.
/// @throws base::InputError  if there are no pictures or all are empty, an option is negative, or the sheet is too
/// large.
Image grid(std::span<const Image> images, const GridOptions& options = {});

/// All pictures side by side in one row.
Image hconcat(std::span<const Image> images, int gap = 8);

}  // namespace foamsim::render
