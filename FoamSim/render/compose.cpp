#include "FoamSim/render/compose.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "Base/error.h"

namespace foamsim::render {
namespace {

// Where each cell starts, and at the end where the sheet ends.
std::vector<int> starts(const std::vector<int>& sizes, const GridOptions& options) {
  std::vector<int> result;
  long long at = options.margin;
  for (const int size : sizes) {
    result.push_back(static_cast<int>(at));
    at += size + static_cast<long long>(options.gap);
    if (at > std::numeric_limits<int>::max() / 2) throw base::InputError("picture grid: the sheet is too large");
  }
  result.push_back(static_cast<int>(at - options.gap + options.margin));
  return result;
}

void paste(const Image& source, Image& sheet, int left, int top) {
  for (int y = 0; y < source.height(); ++y)
    for (int x = 0; x < source.width(); ++x) sheet.at(left + x, top + y) = source.at(x, y);
}

}  // namespace

Image grid(std::span<const Image> images, const GridOptions& options) {
  if (options.columns < 0 || options.gap < 0 || options.margin < 0)
    throw base::InputError("picture grid: columns, gap and margin must be 0 or more");
  if (std::all_of(images.begin(), images.end(), [](const Image& i) { return i.empty(); }))
    throw base::InputError("picture grid: needs at least one picture with pixels");
  const std::size_t columns = options.columns == 0 ? images.size() : static_cast<std::size_t>(options.columns);
  std::vector<int> widths(std::min(columns, images.size()), 0);
  std::vector<int> heights((images.size() + columns - 1) / columns, 0);
  for (std::size_t i = 0; i < images.size(); ++i) {
    widths[i % columns] = std::max(widths[i % columns], images[i].width());
    heights[i / columns] = std::max(heights[i / columns], images[i].height());
  }
  const std::vector<int> left = starts(widths, options);
  const std::vector<int> top = starts(heights, options);
  Image sheet(left.back(), top.back(), options.fill);
  for (std::size_t i = 0; i < images.size(); ++i) {
    const std::size_t column = i % columns;
    const std::size_t row = i / columns;
    paste(images[i], sheet, left[column] + (widths[column] - images[i].width()) / 2,
          top[row] + (heights[row] - images[i].height()) / 2);
  }
  return sheet;
}

Image hconcat(std::span<const Image> images, int gap) {
  GridOptions options;
  options.gap = gap;
  return grid(images, options);
}

}  // namespace foamsim::render
