#pragma once

#include <Eigen/Core>
#include <span>

#include "FoamSim/render/surface.h"

namespace foamsim::render {

/// A perspective camera.
struct Camera {
  /// Where the eye is, in the surface's unit of length.
  Eigen::Vector3d eye = {0, 0, 5};
  /// The point in the middle of the picture; its distance from the eye sets the scale of lines, tubes and thickness
  /// noise.
  Eigen::Vector3d target = {0, 0, 0};
  /// Any vector that points upwards in the picture; not parallel to the viewing direction.
  Eigen::Vector3d up = {0, 1, 0};
  /// Angle between the picture's bottom and top edge, degrees, in (0, 170).
  double vertical_fov = 18;
};

/// Choices of `framing`.
struct FramingOptions {
  /// From the surface towards the eye; any length. Default: 32 degrees beside the x-y plane's normal, 14 degrees above.
  Eigen::Vector3d direction = {0.514, 0.242, 0.823};
  /// Upwards in the picture. Zero (default): the choice that makes the x axis horizontal in the picture (z if looking
  /// along x).
  Eigen::Vector3d up = {0, 0, 0};
  /// Width of the picture over its height.
  double aspect = 4.0 / 3.0;
  /// Angle between the picture's bottom and top edge, degrees.
  double vertical_fov = 18;
  /// How many times larger than it has room the surface is drawn, > 0; what does not fit is cut off by the edges.
  double zoom = 1;
  /// Part of the picture left free on each side of the tighter dimension, in [0, 0.9).
  double margin = 0.06;
};

/// Orthonormal axes of a camera in world coordinates.
struct CameraAxes {
  Eigen::Vector3d right;
  Eigen::Vector3d up;
  /// From the target towards the eye.
  Eigen::Vector3d back;
  /// Half the picture's height at the target, in the surface's unit of length.
  double half_height = 0;
};

/// The axes of `camera`.
/// @throws base::InputError  if the camera is not finite, eye and target coincide, up is parallel to the viewing
///         direction, or the angle is out of range.
CameraAxes camera_axes(const Camera& camera);

/// One camera whose picture holds every vertex of every surface, for instance of a time series or a row of runs.
/// @throws base::InputError  if there is no vertex, a position is not finite, or an option is out of range.
Camera framing(std::span<const Surface> surfaces, const FramingOptions& options = {});

/// The same so far away that the picture holds every vertex from all sides: for cameras that turn around.
Camera framing_all_around(std::span<const Surface> surfaces, const FramingOptions& options = {});

/// A camera that has gone round its target, about the direction upwards in its picture: to the right for positive
/// angles. @param degrees  finite.
Camera turned(const Camera& camera, double degrees);

/// The same for one surface.
Camera framing(const Surface& surface, const FramingOptions& options = {});

}  // namespace foamsim::render
