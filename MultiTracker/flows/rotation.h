#pragma once

#include "MultiTracker/flows/flow.h"

namespace multitracker {

/// Rigid rotation about an axis parallel to z through `centre`, one turn in 2π (Zalesak 1979).
class RotationFlow final : public Flow {
 public:
  explicit RotationFlow(const lostopos::Vec3& centre) : centre_(centre) {}
  lostopos::Vec3 velocity(const lostopos::Vec3& x, double /*time*/) const override {
    return {centre_.y() - x.y(), x.x() - centre_.x(), 0};
  }
  double period() const override;

 private:
  lostopos::Vec3 centre_;
};

}  // namespace multitracker
