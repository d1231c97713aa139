#pragma once

#include "FoamSim/effects/effect.h"

namespace foamsim {

/// Γ *= d^dt: circulation decays by the factor d in a unit of time. Does not move an equilibrium, where Γ has no
/// influence on the shape, only how fast it is reached.
class Damping final : public Effect {
 public:
  /// `factor`: d, dimensionless, in (0, 1]; 1 damps nothing.
  explicit Damping(double factor) : factor_(factor) {}
  std::string_view name() const override { return "damping"; }
  void update_circulation(const EffectStep& step, CirculationField& circulation) override;

 private:
  double factor_;
};

}  // namespace foamsim
