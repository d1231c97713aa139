#pragma once

#include <vector>

#include "FoamSim/effects/effect.h"

namespace foamsim {

/// Γ_v += s dt (mean of the neighbours that hold the same pair − Γ_v): smooths circulation along each film. Before it,
/// the mean of each pair over all vertices is subtracted, which changes no velocity and keeps the numbers small.
class Diffusion final : public Effect {
 public:
  /// `rate`: s, 1/T, ≥ 0. A step that would go past the neighbours' mean (s dt > 1) is cut to it.
  explicit Diffusion(double rate) : rate_(rate) {}
  std::string_view name() const override { return "diffusion"; }
  void update_circulation(const EffectStep& step, CirculationField& circulation) override;

 private:
  double rate_;
  std::vector<std::size_t> begin_;  // where a vertex's values start in smoothed_
  std::vector<double> smoothed_;
};

}  // namespace foamsim
