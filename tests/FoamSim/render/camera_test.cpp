#include "FoamSim/render/camera.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "Base/error.h"
#include "shapes.h"

namespace foamsim::render {
namespace {

using Eigen::Vector3d;

// Place in the picture, both coordinates in [−1, 1] from edge to edge.
Eigen::Vector2d project(const Camera& camera, double aspect, const Vector3d& x) {
  const Vector3d back = (camera.eye - camera.target).normalized();
  const Vector3d right = camera.up.cross(back).normalized();
  const Vector3d up = back.cross(right);
  const Vector3d d = x - camera.eye;
  const double slope = std::tan(camera.vertical_fov * std::numbers::pi / 360);
  return {right.dot(d) / (-back.dot(d) * slope * aspect), up.dot(d) / (-back.dot(d) * slope)};
}

TEST(Framing, every_vertex_is_inside_the_margin_and_one_touches_it) {
  for (const double aspect : {0.4, 1.0, 2.5}) {
    for (const Vector3d& shift : {Vector3d(0, 0, 0), Vector3d(30, -7, 100)}) {
      std::vector<Surface> series{double_bubble(12), sphere(16, 0.3, {2, 1, -1})};
      for (Surface& s : series)
        for (Vector3d& x : s.positions) x += shift;
      FramingOptions options;
      options.aspect = aspect;
      options.margin = 0.1;
      const Camera camera = framing(series, options);
      double largest = 0;
      for (const Surface& s : series)
        for (const Vector3d& x : s.positions)
          largest = std::max(largest, project(camera, aspect, x).lpNorm<Eigen::Infinity>());
      EXPECT_NEAR(largest, 0.9, 1e-9) << "aspect " << aspect;
    }
  }
}

TEST(Framing, x_axis_is_horizontal_by_default) {
  const Camera camera = framing(double_bubble(12));
  const Vector3d& t = camera.target;
  const Eigen::Vector2d left = project(camera, 1, t - Vector3d(0.1, 0, 0));
  const Eigen::Vector2d right = project(camera, 1, t + Vector3d(0.1, 0, 0));
  EXPECT_NEAR(left.y(), 0, 1e-12);
  EXPECT_NEAR(right.y(), 0, 1e-12);
  EXPECT_GT(right.x(), left.x());
}

TEST(Framing, looks_along_x_with_z_to_the_left) {
  FramingOptions options;
  options.direction = {1, 0, 0};
  const Camera camera = framing(sphere(16, 1), options);
  EXPECT_NEAR(project(camera, 1, {0, 0, -0.1}).y(), 0, 1e-12);
  EXPECT_GT(project(camera, 1, {0, 0, -0.1}).x(), 0);
  EXPECT_GT(project(camera, 1, {0, 0.1, 0}).y(), 0);
}

TEST(Framing, scales_with_the_unit_of_length) {
  Surface s = double_bubble(12);
  const Camera small = framing(s);
  for (Vector3d& x : s.positions) x *= 1e6;
  const Camera large = framing(s);
  EXPECT_LT((large.eye - 1e6 * small.eye).norm(), 1e-6);
}

TEST(Framing, zooms_by_the_factor) {
  const Surface s = double_bubble(12);
  FramingOptions options;
  const double plain = camera_axes(framing(s, options)).half_height;
  options.zoom = 2.5;
  EXPECT_NEAR(camera_axes(framing(s, options)).half_height, plain / 2.5, 1e-12);
  options.zoom = 0;
  EXPECT_THROW(framing(s, options), base::InputError);
}

TEST(Framing, all_around_shows_everything_from_every_side) {
  const Surface s = double_bubble(12);
  FramingOptions options;
  options.aspect = 0.7;
  const Camera camera = framing_all_around(std::span(&s, 1), options);
  for (int degrees = 0; degrees < 360; degrees += 30)
    for (const Vector3d& x : s.positions) {
      const Eigen::Vector2d place = project(turned(camera, degrees), options.aspect, x);
      EXPECT_LE(std::max(std::abs(place.x()), std::abs(place.y())), 1) << degrees;
    }
}

TEST(Camera, goes_round_its_target_to_the_right) {
  Camera camera;
  camera.eye = {1, 2, 7};
  camera.target = {1, 2, 3};
  EXPECT_TRUE(turned(camera, 90).eye.isApprox(Vector3d(5, 2, 3), 1e-12));
  EXPECT_TRUE(turned(camera, 360).eye.isApprox(camera.eye, 1e-12));
  EXPECT_THROW(turned(camera, std::numeric_limits<double>::infinity()), base::InputError);
}

TEST(Framing, refuses_what_it_cannot_frame) {
  EXPECT_THROW(framing(std::span<const Surface>{}), base::InputError);
  EXPECT_THROW(framing(Surface{}), base::InputError);
  Surface bad = sphere(8, 1);
  bad.positions[3].y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(framing(bad), base::InputError);
  FramingOptions options;
  options.direction.setZero();
  EXPECT_THROW(framing(sphere(8, 1), options), base::InputError);
  options = {};
  options.up = options.direction;
  EXPECT_THROW(framing(sphere(8, 1), options), base::InputError);
  options = {};
  options.margin = 1;
  EXPECT_THROW(framing(sphere(8, 1), options), base::InputError);
}

}  // namespace
}  // namespace foamsim::render
