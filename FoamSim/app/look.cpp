#include "FoamSim/app/look.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "Base/error.h"
#include "FoamSim/app/frame_fields.h"
#include "FoamSim/app/pictures.h"
#include "FoamSim/render/explode.h"
#include "FoamSim/render/legend.h"
#include "LosTopos/io/mesh_file.h"

namespace foamsim::app {

namespace fs = std::filesystem;

using Eigen::Vector3d;

namespace {

// The vertices that are outermost in some hundred directions, which frame as all do, to a hundredth of their size.
render::Surface outline(const render::Surface& surface) {
  constexpr int directions = 300;
  render::Surface outermost;
  for (int i = 0; i < directions; ++i) {
    // A spiral from pole to pole at the golden angle: evenly over the sphere.
    const double z = 1 - (2 * i + 1.0) / directions;
    const double angle = std::numbers::pi * (3 - std::sqrt(5.0)) * i;
    const Vector3d direction(std::sqrt(1 - z * z) * std::cos(angle), std::sqrt(1 - z * z) * std::sin(angle), z);
    const Vector3d* best = nullptr;
    double most = -std::numeric_limits<double>::infinity();
    for (const auto& triangle : surface.triangles)
      for (const std::uint32_t v : triangle)
        if (const double reach = direction.dot(surface.positions[v]); reach > most) {
          most = reach;
          best = &surface.positions[v];
        }
    if (best != nullptr) outermost.positions.push_back(*best);
  }
  return outermost;
}

render::FieldRange joined(const std::optional<render::FieldRange>& a, const render::FieldRange& b) {
  return a ? render::FieldRange{std::min(a->low, b.low), std::max(a->high, b.high)} : b;
}

render::Surface shaped(render::Surface surface, const Look& look) {
  if (look.cut) surface = render::cut(surface, *look.cut);
  return look.explode > 0 ? render::explode(surface, look.explode) : surface;
}

}  // namespace

Painter::Painter(Look look, std::span<const fs::path> frames, bool all_around) : look_(std::move(look)) {
  std::vector<render::Surface> outlines;
  std::optional<render::FieldRange> range;
  for (const fs::path& frame : frames) {
    const lostopos::SurfaceData data = lostopos::read_surface(frame);
    if (look_.has_field() && !look_.range) range = joined(range, render::range_of(field_values(data, look_.color)));
    outlines.push_back(outline(shaped(to_draw(data), look_)));
  }
  range_ = look_.range.value_or(range.value_or(render::FieldRange{}));
  look_.framing.aspect = static_cast<double>(look_.options.width) / look_.options.height;
  camera_ = all_around ? render::framing_all_around(outlines, look_.framing) : render::framing(outlines, look_.framing);
  if (look_.target) {
    camera_.eye += *look_.target - camera_.target;
    camera_.target = *look_.target;
  }
  if (look_.eye) camera_.eye = *look_.eye;
  render::camera_axes(camera_);  // throws where eye and target do not make a view
}

render::Surface Painter::surface_of(const fs::path& frame) const {
  const lostopos::SurfaceData data = lostopos::read_surface(frame);
  render::Surface surface = to_draw(data);
  if (look_.color == "regions") render::color_by_region(surface);
  if (look_.has_field()) render::color_by_field(surface, field_values(data, look_.color), range_);
  return shaped(std::move(surface), look_);
}

render::Image Painter::draw(const fs::path& frame, double degrees) const {
  const render::Camera camera = render::turned(camera_, degrees);
  render::Image image = render::render(surface_of(frame), camera, look_.options);
  if (look_.has_field()) render::draw_legend(image, look_.color, range_, look_.options.background);
  if (look_.scale_bar) render::draw_scale_bar(image, camera, "L", look_.options.background);
  return image;
}

}  // namespace foamsim::app
