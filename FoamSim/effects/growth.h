#pragma once

#include "FoamSim/effects/effect.h"

namespace foamsim {

/// Normal-flow growth: every vertex on the air's side moves along its area-weighted normal into the air, so that
/// bubbles grow, meet, and press each other into a foam. Films between bubbles stay.
class Growth final : public Effect {
 public:
  /// `rate`: speed of the films, L/T, ≥ 0.
  explicit Growth(double rate) : rate_(rate) {}
  std::string_view name() const override { return "growth"; }
  void add_velocity(const Stage& stage, std::span<lostopos::Vec3> velocity) override;

 private:
  double rate_;
};

}  // namespace foamsim
