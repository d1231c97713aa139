#include "FoamSim/render/render.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

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

TEST(Render, tubes_cover_length_times_width) {
  // One small triangle, held far from the middle of a wide picture by a film seen edge-on: only its rims show.
  Surface s;
  s.positions = {{-1, 0, 1}, {1, 0, 1}, {0, 0, -1}};
  s.triangles = {{0, 1, 2}};
  s.labels = {{1, 0}};
  Camera camera;
  camera.eye = {0, 0, 1000};
  camera.vertical_fov = 2 * std::atan(1.5e-3) * 180 / std::numbers::pi;  // half the picture's height is 1.5
  RenderOptions options = silhouette(150, 150);
  options.tube_radius = 0.04;  // 0.06 in length
  const double expected = (2 * 2 * 0.06 + std::numbers::pi * 0.06 * 0.06) * 50 * 50;
  EXPECT_NEAR(opacity(render(s, camera, options)), expected, 0.02 * expected);
  options.boundary_tubes = false;
  EXPECT_LT(opacity(render(s, camera, options)), 0.01 * expected);
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
