#include "FoamSim/render/colors.h"

#include <gtest/gtest.h>

#include <cmath>

#include "Base/error.h"
#include "FoamSim/render/legend.h"
#include "FoamSim/render/text.h"
#include "FoamSim/render/tone.h"
#include "shapes.h"

namespace foamsim::render {
namespace {

Pixel shown(const Eigen::Vector3f& linear) {
  return {encode_srgb(linear.x()), encode_srgb(linear.y()), encode_srgb(linear.z()), 255};
}

RenderOptions matt_films() {
  RenderOptions options;
  options.width = options.height = 61;
  options.background = Background::transparent;
  options.film_thickness = 1;  // reflects next to nothing
  options.thickness_variation = 0;
  options.color_opacity = 0.9;
  options.tube_radius = 0;
  return options;
}

TEST(Colors, of_regions_show_in_the_picture) {
  Surface s = sphere(64, 1, {0, 0, 0}, 3);
  color_by_region(s);
  const Pixel middle = render(s, Camera{}, matt_films()).at(30, 30);
  const Pixel color = shown(region_color(3));
  // The channels' order in brightness is that of the colour.
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b)
      if (color[a] > color[b] + 60) {
        EXPECT_GT(middle[a], middle[b]) << a << b;
      }
  EXPECT_NE(region_color(3), region_color(4));
}

TEST(Colors, between_two_bubbles_are_their_mean) {
  Surface s = sphere(8, 1, {0, 0, 0}, 1, 2);
  color_by_region(s);
  EXPECT_TRUE(s.colors[0][0].isApprox(0.5f * (region_color(1) + region_color(2))));
}

TEST(Colors, of_a_field_go_from_one_end_of_the_map_to_the_other) {
  const FieldRange range{-1, 3};
  EXPECT_EQ(shown(field_color(-1, range)), (Pixel{68, 1, 84, 255}));  // viridis' ends
  EXPECT_EQ(shown(field_color(3, range)), (Pixel{253, 231, 37, 255}));
  EXPECT_EQ(field_color(7, range), field_color(3, range));
  EXPECT_TRUE(field_color(NAN, range).isApproxToConstant(0.2f));
}

TEST(Colors, cover_the_films_of_a_field) {
  Surface s = sphere(64, 1);
  std::vector<double> values;
  for (const auto& triangle : s.triangles)
    for (const std::uint32_t v : triangle) values.push_back(s.positions[v].x());
  color_by_field(s, values, range_of(values));
  const Image image = render(s, Camera{}, matt_films());
  const Pixel left = image.at(6, 30), right = image.at(54, 30);
  EXPECT_GT(left[2], left[1]);    // dark violet
  EXPECT_GT(right[1], right[2]);  // yellow
  values.pop_back();
  EXPECT_THROW(color_by_field(s, values, {0, 1}), base::InputError);
}

TEST(Colors, have_a_range_of_what_is_finite) {
  const std::vector<double> values{3, NAN, -2, INFINITY};
  EXPECT_EQ(range_of(values).low, -2);
  EXPECT_EQ(range_of(values).high, 3);
  const FieldRange same = range_of(std::vector<double>{5, 5});
  EXPECT_LT(same.low, 5);
  EXPECT_GT(same.high, 5);
  EXPECT_LT(range_of({}).low, range_of({}).high);
}

TEST(Legend, has_the_ends_of_the_range_at_the_ends_of_its_bar) {
  Image image(400, 300, {0, 0, 0, 255});
  const FieldRange range{2, 4};
  draw_legend(image, "pressure", range, Background::dark);
  EXPECT_EQ(image.at(395, 75), shown(field_color(4, range)));
  EXPECT_EQ(image.at(395, 224), shown(field_color(2, range)));
  EXPECT_EQ(image.at(395, 226), (Pixel{0, 0, 0, 255}));
  Image tiny(20, 20, {0, 0, 0, 255});
  draw_legend(tiny, "pressure", range, Background::dark);
  EXPECT_EQ(tiny, Image(20, 20, {0, 0, 0, 255}));
}

TEST(ScaleBar, is_as_long_as_its_length_looks) {
  Image image(400, 300, {0, 0, 0, 255});
  Camera camera;
  camera.eye = {0, 0, 10};
  camera.vertical_fov = 2 * std::atan(0.3) * 180 / 3.14159265358979;  // 6 units from bottom to top
  draw_scale_bar(image, camera, "L", Background::dark);
  int longest = 0;
  for (int y = 0; y < 300; ++y) {
    int row = 0;
    for (int x = 0; x < 400; ++x) row += image.at(x, y)[0] > 100 ? 1 : 0;
    longest = std::max(longest, row);
  }
  EXPECT_EQ(longest, 100);  // 2 L at 50 pixels a unit
}

TEST(Text, leaves_out_what_is_outside) {
  Image image(10, 10, {0, 0, 0, 255});
  draw_text(image, 7, 8, "Wide \xe2", 2, {255, 255, 255, 255});
  EXPECT_EQ(image.at(7, 8)[0], 255);  // the left stroke of W
  EXPECT_EQ(text_width("ab", 2), 22);
}

}  // namespace
}  // namespace foamsim::render
