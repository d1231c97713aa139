#include "FoamSim/render/environment.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace foamsim::render {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;

float smoothstep(float low, float high, float x) {
  const float t = std::clamp((x - low) / (high - low), 0.0f, 1.0f);
  return t * t * (3 - 2 * t);
}

Vector3f mix(const Vector3f& a, const Vector3f& b, float t) {
  return a + t * (b - a);
}

Vector3f sky() {
  return {0.42f, 0.50f, 0.62f};
}
Vector3f horizon() {
  return {0.55f, 0.60f, 0.66f};
}
Vector3f floor_light() {
  return {0.16f, 0.15f, 0.15f};
}
Vector3f key_direction() {
  return {-0.62f, 0.55f, 0.56f};
}

}  // namespace

// View coordinates: x to the right, y up, z towards the viewer.
Environment::Environment(const CameraAxes& axes, float room)
    : room_(room),
      boxes_{make_box(key_direction(), {0.26f, 0.34f}, {13.0f, 12.8f, 12.3f}, 2, 0.02f),
             make_box({0.90f, 0.12f, 0.36f}, {0.10f, 0.62f}, {5.0f, 5.4f, 6.2f}, 1, 0.03f),
             make_box({0.10f, 0.93f, -0.20f}, {0.65f, 0.22f}, {5.0f, 5.0f, 5.0f}, 1, 0.10f),
             make_box({-0.96f, -0.10f, -0.20f}, {0.10f, 0.50f}, {3.0f, 3.1f, 3.3f}, 1, 0.06f),
             make_box({0.35f, -0.72f, 0.55f}, {0.40f, 0.16f}, {1.7f, 1.5f, 1.3f}, 1, 0.10f)} {
  to_view_ << axes.right.cast<float>().transpose(), axes.up.cast<float>().transpose(),
      axes.back.cast<float>().transpose();
}

Environment::SoftBox Environment::make_box(const Vector3f& centre, const Vector2f& half, const Vector3f& radiance,
                                           int panes, float edge) {
  const Vector3f c = centre.normalized();
  const Vector3f hint = std::abs(c.y()) > 0.9f ? Vector3f::UnitZ() : Vector3f::UnitY();
  const Vector3f across = hint.cross(c).normalized();
  return {c, across, c.cross(across), half, radiance, panes, edge};
}

float Environment::coverage(const SoftBox& box, const Vector3f& direction) {
  const float facing = direction.dot(box.centre);
  if (facing <= 0.05f) return 0;
  const float u = direction.dot(box.across) / (facing * box.half.x());
  const float v = direction.dot(box.along) / (facing * box.half.y());
  const float soft = box.edge / box.half.minCoeff();
  float light = (1 - smoothstep(1 - soft, 1 + soft, std::abs(u))) * (1 - smoothstep(1 - soft, 1 + soft, std::abs(v)));
  if (box.panes == 2 && light > 0) {  // a cross of bars
    const float bar = 0.05f;
    light *= smoothstep(bar, bar + soft, std::abs(u)) * smoothstep(bar, bar + soft, std::abs(v));
  }
  return light;
}

Vector3f Environment::radiance(const Vector3f& direction) const {
  const Vector3f d = to_view_ * direction;
  Vector3f light = d.y() >= 0 ? mix(horizon(), sky(), smoothstep(0.0f, 0.8f, d.y()))
                              : mix(horizon(), floor_light(), smoothstep(0.0f, 0.5f, -d.y()));
  // The room behind the viewer is darker, so that face-on reflections stay clear and only the lights show.
  light *= room_ * (1 - 0.55f * smoothstep(-0.3f, 0.8f, d.z()));
  for (const SoftBox& box : boxes_) {
    const float part = coverage(box, d);
    if (part > 0) light += part * box.radiance;
  }
  return light;
}

Vector3f Environment::ambient(const Vector3f& normal) const {
  const Vector3f n = to_view_ * normal;
  const Vector3f key = key_direction().normalized();
  const Vector3f hemisphere = mix(floor_light(), sky(), 0.5f + 0.5f * n.y());
  return room_ * (hemisphere + Vector3f::Constant(0.55f * std::max(0.0f, n.dot(key))));
}

}  // namespace foamsim::render
