#include "FoamSim/render/camera.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "Base/error.h"

namespace foamsim::render {
namespace {

using Eigen::Vector3d;

double half_tangent(double degrees) {
  if (!(degrees > 0 && degrees < 170))
    throw base::InputError("camera: vertical_fov is " + std::to_string(degrees) + ", must be in (0, 170) degrees");
  return std::tan(degrees * std::numbers::pi / 360);
}

// The coordinate axis crossed with the viewing direction gives "up" with that axis horizontal.
Vector3d level_up(const Vector3d& back) {
  const Vector3d axis = std::abs(back.x()) < 0.95 ? Vector3d(1, 0, 0) : Vector3d(0, 0, -1);
  return back.cross(axis);
}

void check(const FramingOptions& options) {
  if (!options.direction.allFinite() || options.direction.norm() == 0)
    throw base::InputError("framing: direction must be finite and not zero");
  if (!options.up.allFinite()) throw base::InputError("framing: up must be finite");
  if (!(std::isfinite(options.aspect) && options.aspect > 0))
    throw base::InputError("framing: aspect must be positive and finite");
  if (!(options.zoom > 0 && std::isfinite(options.zoom))) throw base::InputError("framing: zoom must be positive");
  if (!(options.margin >= 0 && options.margin < 0.9)) throw base::InputError("framing: margin must be in [0, 0.9)");
}

template <class F>
void for_each_vertex(std::span<const Surface> surfaces, F&& f) {
  for (const Surface& surface : surfaces)
    for (const Vector3d& x : surface.positions) f(x);
}

Eigen::AlignedBox3d box_of(std::span<const Surface> surfaces, const Eigen::Matrix3d& to_view) {
  Eigen::AlignedBox3d box;
  for_each_vertex(surfaces, [&](const Vector3d& x) {
    if (!x.allFinite()) throw base::InputError("framing: a vertex position is not finite");
    box.extend(to_view * x);
  });
  if (box.isEmpty()) throw base::InputError("framing: the surfaces have no vertices");
  return box;
}

// At distance 1 from the origin.
Camera unit_camera(const FramingOptions& options) {
  Camera camera;
  camera.vertical_fov = options.vertical_fov;
  camera.target.setZero();
  camera.eye = options.direction.stableNormalized();
  camera.up = options.up.isZero(0) ? level_up(camera.eye) : options.up;
  return camera;
}

Camera zoomed(Camera camera, double zoom) {
  camera.vertical_fov = std::atan(half_tangent(camera.vertical_fov) / zoom) * 360 / std::numbers::pi;
  return camera;
}

}  // namespace

CameraAxes camera_axes(const Camera& camera) {
  const double slope = half_tangent(camera.vertical_fov);
  const Vector3d view = camera.eye - camera.target;
  if (!view.allFinite() || !camera.up.allFinite()) throw base::InputError("camera: eye, target and up must be finite");
  const double distance = view.stableNorm();
  if (!(distance > 0)) throw base::InputError("camera: eye and target must not coincide");
  CameraAxes axes;
  axes.back = view / distance;
  const Vector3d right = camera.up.stableNormalized().cross(axes.back);
  if (!(right.norm() > 1e-6))
    throw base::InputError("camera: up must not be zero or parallel to the viewing direction");
  axes.right = right.normalized();
  axes.up = axes.back.cross(axes.right);
  axes.half_height = slope * distance;
  return axes;
}

Camera framing(std::span<const Surface> surfaces, const FramingOptions& options) {
  check(options);
  Camera camera = unit_camera(options);
  const CameraAxes axes = camera_axes(camera);
  Eigen::Matrix3d to_view;
  to_view << axes.right.transpose(), axes.up.transpose(), axes.back.transpose();

  const Eigen::AlignedBox3d box = box_of(surfaces, to_view);

  // Smallest distance from the box's centre at which every vertex projects inside the margins.
  const double free = 1 - options.margin;
  const double slope_y = half_tangent(options.vertical_fov) * free;
  const double slope_x = slope_y * options.aspect;
  const Vector3d centre = box.center();
  double distance = 0;
  for_each_vertex(surfaces, [&](const Vector3d& x) {
    const Vector3d p = to_view * x - centre;
    distance = std::max({distance, std::abs(p.x()) / slope_x + p.z(), std::abs(p.y()) / slope_y + p.z()});
  });
  if (!(distance > 0)) distance = 1;  // a single point: any distance shows it
  camera.target = to_view.transpose() * centre;
  camera.eye = camera.target + distance * axes.back;
  camera.up = axes.up;
  return zoomed(camera, options.zoom);
}

Camera framing_all_around(std::span<const Surface> surfaces, const FramingOptions& options) {
  check(options);
  const Eigen::AlignedBox3d box = box_of(surfaces, Eigen::Matrix3d::Identity());
  Camera camera = unit_camera(options);
  const Vector3d back = camera_axes(camera).back;
  camera.target = box.center();
  double radius = 0;
  for_each_vertex(surfaces, [&](const Vector3d& x) { radius = std::max(radius, (x - camera.target).norm()); });
  if (!(radius > 0)) radius = 1;
  const double slope = half_tangent(options.vertical_fov) * (1 - options.margin) * std::min(options.aspect, 1.0);
  camera.eye = camera.target + radius * std::sqrt(1 + 1 / (slope * slope)) * back;
  return zoomed(camera, options.zoom);
}

Camera turned(const Camera& camera, double degrees) {
  if (!std::isfinite(degrees)) throw base::InputError("camera: an angle to turn by must be finite");
  const CameraAxes axes = camera_axes(camera);
  const Eigen::AngleAxisd turn(degrees * std::numbers::pi / 180, axes.up);
  Camera result = camera;
  result.eye = camera.target + turn * (camera.eye - camera.target);
  result.up = axes.up;
  return result;
}

Camera framing(const Surface& surface, const FramingOptions& options) {
  return framing(std::span(&surface, 1), options);
}

}  // namespace foamsim::render
