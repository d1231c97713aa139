#include "MultiTracker/scenes/shapes/slotted_disc.h"

#include <cmath>
#include <numbers>

#include "MultiTracker/scenes/shapes/extruded_cells.h"

namespace multitracker {

using Eigen::Vector2d;
using lostopos::SurfaceMesh;

namespace {

// Two lobes beside the slot and the bridge above it, all convex. Angles count from the positive y axis.
class DiscCells {
 public:
  explicit DiscCells(const SlottedDiscOptions& options) : o_(options) {}

  PlaneCells cells() {
    const double w = o_.slot_width / 2, top = o_.slot_depth - o_.radius;
    const double above = std::asin(w / o_.radius), below = std::numbers::pi - above;
    const auto segments = [this](double angle) {
      return std::max(1L, std::lround(static_cast<double>(o_.segments) * angle / (2 * std::numbers::pi)));
    };
    const std::size_t inner_right = add({w, top}), inner_left = add({-w, top});
    // From the bridge's right end clockwise to the slot, and its mirror image.
    std::vector<std::size_t> right, left;
    const long n = segments(below - above);
    for (long i = 0; i <= n; ++i) {
      const double angle = above + (below - above) * static_cast<double>(i) / static_cast<double>(n);
      const Vector2d x = o_.radius * Vector2d(std::sin(angle), std::cos(angle));
      right.push_back(add(x));
      left.push_back(add({-x.x(), x.y()}));
    }
    add_cell({right.rbegin(), right.rend()}, {inner_right});
    add_cell(left, {inner_left});
    add_cell({inner_right, right.front(), left.front(), inner_left}, {});
    return std::move(cells_);
  }

 private:
  std::size_t add(const Vector2d& x) {
    cells_.corners.push_back(Vector2d(o_.centre.x(), o_.centre.y()) + x);
    return cells_.corners.size() - 1;
  }
  void add_cell(std::vector<std::size_t> corners, const std::vector<std::size_t>& more) {
    corners.insert(corners.end(), more.begin(), more.end());
    cells_.cells.push_back({std::move(corners), lostopos::Region(1)});
  }

  const SlottedDiscOptions& o_;
  PlaneCells cells_;
};

}  // namespace

SurfaceMesh slotted_disc(const SlottedDiscOptions& options) {
  const double side = 2 * std::numbers::pi * options.radius / static_cast<double>(options.segments);
  const long layers = std::max(1L, std::lround(options.thickness / side));
  SurfaceMesh mesh =
      triangulated(extruded(DiscCells(options).cells(), options.thickness, layers), options.subdivisions);
  for (lostopos::Vertex v : mesh.vertices())
    mesh.set_position(v, mesh.position(v) + lostopos::Vec3(0, 0, options.centre.z() - options.thickness / 2));
  return mesh;
}

}  // namespace multitracker
