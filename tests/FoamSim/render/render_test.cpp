#include "FoamSim/render/render.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "FoamSim/render/film_optics.h"
#include "shapes.h"

namespace foamsim::render {
namespace {

using Eigen::Vector3d;

double opacity(const Image& image) {
  double sum = 0;
  for (const Pixel& p : image.pixels()) sum += p[3] / 255.0;
  return sum;
}

// As one pixel that has the light of all of them, mean of the colours, of 255.
double mean_of_block(const Image& image, int left, int top, int size) {
  double sum = 0;
  for (int y = top; y < top + size; ++y)
    for (int x = left; x < left + size; ++x)
      for (std::size_t i = 0; i < 3; ++i) sum += std::pow(image.at(x, y)[i] / 255.0, 2.2);
  return 255 * std::pow(sum / (3.0 * size * size), 1 / 2.2);
}

// Films so dense that they let nothing through: the alpha channel is then the covered part of each pixel.
RenderOptions silhouette(int width, int height) {
  RenderOptions options;
  options.width = width;
  options.height = height;
  options.background = Background::transparent;
  options.film_density = 100;
  options.interreflection = false;
  return options;
}

TEST(Render, covers_the_projected_area_of_a_sphere) {
  const Surface s = sphere(128, 0.7, {0.2, -0.1, 0.3});
  Camera camera;
  camera.target = {0.2, -0.1, 0.3};
  camera.eye = camera.target + Vector3d(1, 2, 3);
  camera.vertical_fov = 40;
  const RenderOptions options = silhouette(200, 150);
  // The visible cone has sine r/D; it cuts the plane through the target in a circle.
  const double distance = std::sqrt(14.0);
  const double radius = 0.7 / std::sqrt(1 - 0.49 / 14);
  const double pixels_per_length = 75 / (distance * std::tan(20 * std::numbers::pi / 180));
  const double expected = std::numbers::pi * std::pow(radius * pixels_per_length, 2);
  EXPECT_NEAR(opacity(render(s, camera, options)), expected, 0.004 * expected);
}

// One triangle that is seen edge-on from far away: only its rims show, a line in the middle of the picture, along a row
// of pixels' edges. Half the picture's height is 1.5.
struct EdgeOn {
  Surface surface;
  Camera camera;

  EdgeOn() {
    surface.positions = {{-1, 0, 1}, {1, 0, 1}, {0, 0, -1}};
    surface.triangles = {{0, 1, 2}};
    surface.labels = {{1, 0}};
    camera.eye = {0, 0, 1000};
    camera.vertical_fov = 2 * std::atan(1.5e-3) * 180 / std::numbers::pi;
  }
};

TEST(Render, tubes_cover_length_times_width) {
  const EdgeOn line;
  RenderOptions options = silhouette(150, 150);
  options.tube_radius = 0.04;  // 0.06 in length
  const double expected = (2 * 2 * 0.06 + std::numbers::pi * 0.06 * 0.06) * 50 * 50;
  EXPECT_NEAR(opacity(render(line.surface, line.camera, options)), expected, 0.02 * expected);
  options.boundary_tubes = false;
  EXPECT_LT(opacity(render(line.surface, line.camera, options)), 0.01 * expected);
}

TEST(Render, lines_between_the_middles_of_pixels_are_not_missed) {
  const EdgeOn line;
  RenderOptions options = silhouette(150, 150);
  for (const double width : {0.4, 0.8, 1.2}) {  // pixels
    options.tube_radius = width / 150;
    EXPECT_NEAR(opacity(render(line.surface, line.camera, options)), 100 * width, 10 * width) << width;
  }
}

// Seen face-on each film passes (1 − R) exp(−density); a ray through the middle of k spheres crosses 2 k of them.
TEST(Render, layers_multiply) {
  RenderOptions options;
  options.width = options.height = 41;
  options.background = Background::transparent;
  options.film_density = 0.1;
  options.thickness_variation = 0;
  options.iridescence = 0;
  options.film_thickness = 250;
  const double reflectance = FilmColorTable(500).reflectance(1, 250).mean();
  Surface s;
  for (int spheres = 1; spheres <= 4; ++spheres) {
    append(s, sphere(64, 1.0 / spheres, {0, 0, 0}, spheres, spheres - 1));
    const double passed = std::pow((1 - reflectance) * std::exp(-0.1), 2 * spheres);
    EXPECT_NEAR(render(s, Camera{}, options).at(20, 20)[3] / 255.0, 1 - passed, 1.0 / 255) << spheres;
  }
}

TEST(Render, rim_is_more_opaque_than_the_middle) {
  RenderOptions options;
  options.width = options.height = 101;
  options.background = Background::transparent;
  Camera camera;
  camera.eye = {0, 0, 8};
  camera.vertical_fov = 16;
  const Image image = render(sphere(64, 1), camera, options);
  // Half the picture's height is 8 tan 8° = 1.124, so the silhouette crosses the middle row near pixel 95.
  EXPECT_GT(image.at(93, 50)[3], 3 * image.at(60, 50)[3]);
  EXPECT_EQ(image.at(99, 50)[3], 0);
}

// Rays are saved where pixels look alike: what is seen is what a picture of sixteen times as many shows, thin lines,
// seen from everywhere, too.
TEST(Render, saved_rays_are_not_missed) {
  const Surface s = double_bubble(24);
  RenderOptions options;
  options.width = 160;
  options.height = 120;
  for (const double tube_radius : {0.009, 0.0035, 0.0}) {
    options.tube_radius = tube_radius;
    RenderOptions fine = options;
    fine.width *= 4;
    fine.height *= 4;
    const Image few = render(s, options), many = render(s, fine);
    constexpr int block = 8;
    double largest = 0;
    for (int y = 0; y < options.height; y += block)
      for (int x = 0; x < options.width; x += block)
        largest =
            std::max(largest, std::abs(mean_of_block(few, x, y, block) - mean_of_block(many, 4 * x, 4 * y, 4 * block)));
    EXPECT_LT(largest, 3.5) << "of 255, tubes of " << tube_radius;
  }
}

TEST(Render, same_bits_with_one_thread_and_two) {
  const tbb::global_control allow(tbb::global_control::max_allowed_parallelism, 2);
  RenderOptions options;
  options.width = 97;
  options.height = 61;
  options.samples = 5;
  options.wireframe = true;
  const Surface s = double_bubble(24);
  Image one;
  Image two;
  tbb::task_arena(1).execute([&] { one = render(s, options); });
  tbb::task_arena(2).execute([&] { two = render(s, options); });
  EXPECT_EQ(one, two);
}

TEST(Render, does_not_depend_on_the_unit_of_length) {
  RenderOptions options;
  options.width = 80;
  options.height = 60;
  Surface s = double_bubble(24);
  const Image metres = render(s, options);
  for (Vector3d& x : s.positions) x *= 1024;  // a power of two: not a bit changes
  EXPECT_EQ(render(s, options), metres);
}

TEST(Render, options_change_the_picture) {
  const Surface s = double_bubble(24);
  RenderOptions plain;
  plain.width = 80;
  plain.height = 60;
  const Image base = render(s, plain);
  RenderOptions o = plain;
  o.wireframe = true;
  EXPECT_NE(render(s, o), base);
  o = plain;
  o.tube_radius = 0;
  EXPECT_NE(render(s, o), base);
  o = plain;
  o.film_thickness = 600;
  EXPECT_NE(render(s, o), base);
  o = plain;
  o.exposure = 2;
  EXPECT_NE(render(s, o), base);
  o = plain;
  o.background = Background::white;
  const Image white = render(s, o);
  EXPECT_EQ(white.at(0, 0), (Pixel{255, 255, 255, 255}));
  EXPECT_EQ(white.at(79, 59), (Pixel{255, 255, 255, 255}));
}

}  // namespace
}  // namespace foamsim::render
