#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "Base/error.h"
#include "FoamSim/render/render.h"
#include "shapes.h"

namespace foamsim::render {
namespace {

RenderOptions small() {
  RenderOptions options;
  options.width = 40;
  options.height = 30;
  options.samples = 2;
  return options;
}

TEST(RenderInput, refuses_broken_surfaces) {
  const Camera camera;
  const auto refused = [&](const std::function<void(Surface&)>& breakage) {
    Surface s = sphere(8, 1);
    breakage(s);
    EXPECT_THROW(render(s, camera, small()), base::InputError);
  };
  refused([](Surface& s) { s = Surface{}; });
  refused([](Surface& s) { s.triangles.clear(), s.labels.clear(); });
  refused([](Surface& s) { s.labels.pop_back(); });
  refused([](Surface& s) { s.hidden = {1}; });
  refused([](Surface& s) { s.triangles[3][1] = 100000; });
  refused([](Surface& s) { s.positions[2].x() = std::numeric_limits<double>::infinity(); });
}

TEST(RenderInput, refuses_options_out_of_range) {
  const Surface s = sphere(8, 1);
  const auto refused = [&](const std::function<void(RenderOptions&)>& breakage) {
    RenderOptions options = small();
    breakage(options);
    EXPECT_THROW(render(s, options), base::InputError);
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  refused([](RenderOptions& o) { o.width = 0; });
  refused([](RenderOptions& o) { o.height = -3; });
  refused([](RenderOptions& o) { o.samples = 0; });
  refused([](RenderOptions& o) { o.film_thickness = 0; });
  refused([&](RenderOptions& o) { o.film_thickness = nan; });
  refused([](RenderOptions& o) { o.thickness_variation = 1.5; });
  refused([](RenderOptions& o) { o.iridescence = -1; });
  refused([](RenderOptions& o) { o.film_density = -1; });
  refused([](RenderOptions& o) { o.tube_radius = 2; });
  refused([&](RenderOptions& o) { o.wireframe_width = nan; });
  refused([](RenderOptions& o) { o.exposure = 0; });
}

TEST(RenderInput, refuses_cameras_that_see_nothing) {
  const Surface s = sphere(8, 1);
  Camera camera;
  camera.eye = camera.target;
  EXPECT_THROW(render(s, camera, small()), base::InputError);
  camera = {};
  camera.up = camera.eye - camera.target;
  EXPECT_THROW(render(s, camera, small()), base::InputError);
  camera = {};
  camera.vertical_fov = 180;
  EXPECT_THROW(render(s, camera, small()), base::InputError);
}

TEST(RenderInput, triangles_of_zero_area_change_no_pixel) {
  Surface s = sphere(16, 1);
  const Camera camera = framing(s);
  RenderOptions options = small();
  options.tube_radius = 0;
  const Image clean = render(s, camera, options);
  const auto v = static_cast<std::uint32_t>(s.positions.size());
  s.positions.insert(s.positions.end(), {{0, 0, 2}, {0, 0.3, 2}, {0, 0.9, 2}, {0.3, 0.3, 0.3}, {0.3, 0.3, 0.3}});
  for (const std::array<std::uint32_t, 3>& t :
       {std::array{v, v + 1, v + 2}, {v, v, v + 1}, {v, v, v}, {v, v + 3, v + 4}}) {
    s.triangles.push_back(t);
    s.labels.push_back({1, 0});
  }
  EXPECT_EQ(render(s, camera, options), clean);
}

TEST(RenderInput, nothing_visible_gives_the_backdrop) {
  Surface s = sphere(16, 1);
  RenderOptions options = small();
  options.background = Background::white;
  s.hidden.assign(s.triangles.size(), 1);
  EXPECT_EQ(render(s, options), Image(40, 30, {255, 255, 255, 255}));
  s.hidden.clear();
  for (auto& t : s.triangles) t[1] = t[0];
  EXPECT_EQ(render(s, options), Image(40, 30, {255, 255, 255, 255}));
  options.background = Background::transparent;
  EXPECT_EQ(render(s, options), Image(40, 30, {0, 0, 0, 0}));
}

TEST(RenderInput, a_camera_inside_a_bubble_works) {
  Camera camera;
  camera.eye = {0.1, 0, 0};
  RenderOptions options = small();
  options.background = Background::transparent;
  const Image image = render(sphere(16, 1), camera, options);
  for (const Pixel& p : image.pixels()) EXPECT_GT(p[3], 0);
}

}  // namespace
}  // namespace foamsim::render
