#pragma once

#include <Eigen/Core>
#include <array>

#include "FoamSim/render/camera.h"

namespace foamsim::render {

/// The studio around the films: a soft gradient and a few rectangular lights, all fixed to the camera, so that any view
/// of any scene is lit alike.
class Environment {
 public:
  /// @param room  factor on the gradient, not on the lights: below 1, films show darker than the backdrop.
  Environment(const CameraAxes& axes, float room);

  /// Radiance (linear sRGB, diffuse white about 1) that arrives from unit world direction `direction`.
  Eigen::Vector3f radiance(const Eigen::Vector3f& direction) const;

  /// Light on a matt surface with unit world normal `normal`, as the radiance of a white one.
  Eigen::Vector3f ambient(const Eigen::Vector3f& normal) const;

 private:
  struct SoftBox {
    Eigen::Vector3f centre, across, along;  // orthonormal
    Eigen::Vector2f half;                   // tangents of the half-angles
    Eigen::Vector3f radiance;
    int panes = 1;  // window panes each way
    float edge = 0.03f;
  };

  static float coverage(const SoftBox& box, const Eigen::Vector3f& direction);
  static SoftBox make_box(const Eigen::Vector3f& centre, const Eigen::Vector2f& half, const Eigen::Vector3f& radiance,
                          int panes, float edge);

  Eigen::Matrix3f to_view_;
  float room_;
  std::array<SoftBox, 5> boxes_;
};

}  // namespace foamsim::render
