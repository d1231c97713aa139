#pragma once

#include "FoamSim/effects/effect.h"

namespace foamsim {

/// Which way a vertex grows.
enum class GrowthNormals {
  area_weighted,  ///< along the area-weighted normal of its triangles at the air, as a velocity of the step
  unit            ///< by the mean of their unit normals, before the step, as far as nothing intersects
};

/// Normal-flow growth: every vertex on the air's side moves along its normal into the air, so that bubbles grow, meet,
/// and press each other into a foam. Films between bubbles stay. By the mean of the unit normals sharp corners grow
/// more slowly than faces; what is held stays then.
class Growth final : public Effect {
 public:
  /// `rate`: speed of the films, L/T, ≥ 0.
  explicit Growth(double rate, GrowthNormals normals = GrowthNormals::area_weighted) : rate_(rate), normals_(normals) {}
  std::string_view name() const override { return "growth"; }
  std::vector<lostopos::Vec3> displaced(const EffectStep& step) override;
  void add_velocity(const Stage& stage, std::span<lostopos::Vec3> velocity) override;

 private:
  double rate_;
  GrowthNormals normals_;
};

}  // namespace foamsim
