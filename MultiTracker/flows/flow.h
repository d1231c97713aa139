#pragma once

#include <limits>

#include "LosTopos/vec3.h"

namespace multitracker {

/// A prescribed velocity field that a surface is moved by.
class Flow {
 public:
  Flow() = default;
  Flow(const Flow&) = delete;
  Flow& operator=(const Flow&) = delete;
  virtual ~Flow() = default;
  /// Velocity (L/T) at a point (L) and a time (T).
  virtual lostopos::Vec3 velocity(const lostopos::Vec3& x, double time) const = 0;
  /// The time after which the flow has brought everything back to where it started, T; infinite when it never does.
  virtual double period() const { return std::numeric_limits<double>::infinity(); }
};

}  // namespace multitracker
