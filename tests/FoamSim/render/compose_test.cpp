#include "FoamSim/render/compose.h"

#include <gtest/gtest.h>

#include <vector>

#include "Base/error.h"

namespace foamsim::render {
namespace {

constexpr Pixel kRed{255, 0, 0, 255};
constexpr Pixel kGreen{0, 255, 0, 255};
constexpr Pixel kBlue{0, 0, 255, 128};
constexpr Pixel kGrey{9, 9, 9, 255};

TEST(Grid, places_every_picture) {
  const std::vector<Image> images{Image(4, 2, kRed), Image(3, 6, kGreen), Image(2, 2, kBlue)};
  const Image sheet = grid(images, {.columns = 2, .gap = 1, .margin = 2, .fill = kGrey});
  // Columns 4 and 3 wide, rows 6 and 2 high.
  ASSERT_EQ(sheet.width(), 2 + 4 + 1 + 3 + 2);
  ASSERT_EQ(sheet.height(), 2 + 6 + 1 + 2 + 2);
  int red = 0;
  int green = 0;
  int blue = 0;
  for (int y = 0; y < sheet.height(); ++y) {
    for (int x = 0; x < sheet.width(); ++x) {
      const bool in_red = x >= 2 && x < 6 && y >= 4 && y < 6;  // centred in a row that is 6 high
      const bool in_green = x >= 7 && x < 10 && y >= 2 && y < 8;
      const bool in_blue = x >= 3 && x < 5 && y >= 9 && y < 11;
      red += in_red;
      green += in_green;
      blue += in_blue;
      EXPECT_EQ(sheet.at(x, y), in_red ? kRed : in_green ? kGreen : in_blue ? kBlue : kGrey) << x << ", " << y;
    }
  }
  EXPECT_EQ(red, 8);
  EXPECT_EQ(green, 18);
  EXPECT_EQ(blue, 4);
}

TEST(Grid, one_row_by_default_and_empty_pictures_leave_their_cell_blank) {
  const std::vector<Image> images{Image(2, 1, kRed), Image(), Image(1, 1, kGreen)};
  const Image sheet = hconcat(images, 3);
  ASSERT_EQ(sheet.width(), 2 + 3 + 0 + 3 + 1);
  ASSERT_EQ(sheet.height(), 1);
  EXPECT_EQ(sheet.at(1, 0), kRed);
  EXPECT_EQ(sheet.at(4, 0), (Pixel{255, 255, 255, 255}));
  EXPECT_EQ(sheet.at(8, 0), kGreen);
}

TEST(Grid, refuses_no_pictures_and_negative_gaps) {
  EXPECT_THROW(grid({}), base::InputError);
  const std::vector<Image> images{Image(2, 1, kRed)};
  EXPECT_THROW(grid(images, {.gap = -1}), base::InputError);
  EXPECT_THROW(grid(images, {.columns = -1}), base::InputError);
  EXPECT_THROW(grid(images, {.margin = 40000}), base::InputError);
  EXPECT_THROW(Image(0, 4), base::InputError);
}

}  // namespace
}  // namespace foamsim::render
