#pragma once

#include "FoamSim/effects/effect.h"

namespace foamsim {

/// Γ *= d^dt: circulation decays by the factor d in a unit of time. Does not move an equilibrium, where Γ has no
/// influence on the shape, only how fast it is reached.
class Damping final : public Effect {
 public:
  /// `factor`: d, dimensionless, in (0, 1]; 1 damps nothing. `from`: steps that begin before this time (T) are not
  /// damped, so that a surface can swing freely before it is brought to rest.
  explicit Damping(double factor, double from = 0) : factor_(factor), from_(from) {}
  std::string_view name() const override { return "damping"; }
  void update_circulation(const EffectStep& step, CirculationField& circulation) override;

 private:
  double factor_, from_;
};

}  // namespace foamsim
