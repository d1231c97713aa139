#pragma once

#include <memory>

#include "FoamSim/effects/effect.h"
#include "FoamSim/sheet/pressure/pressure_scheme.h"

namespace foamsim {

/// Γ_v^{pq} += c (P_v^p − P_v^q) dt with a pressure scheme's values P and coefficient c (for edge_angle σ (H_v^p −
/// H_v^q), Da et al. 2015): the pressure jump of curved films drives the air. At held vertices Γ stays: the force there
/// is the wire's.
class SurfaceTension final : public Effect {
 public:
  /// `sigma`: tension of one film side over density, L³/T², ≥ 0. `scheme`: null where the dynamics take forces.
  SurfaceTension(double sigma, std::unique_ptr<PressureScheme> scheme) : sigma_(sigma), scheme_(std::move(scheme)) {}
  std::string_view name() const override { return "surface_tension"; }
  void update_circulation(const EffectStep& step, CirculationField& circulation) override;
  /// 4σ times the exact gradient of the triangles' areas; nothing where a scheme drives circulation.
  void add_force(const Stage& stage, std::span<lostopos::Vec3> force) override;
  /// 4σ times the total area: the jump of the potential is 2Γ, so both sides of a film together pull with 4σ.
  double potential_energy(const SurfaceGeometry& geometry) const override { return 4 * sigma_ * geometry.total_area(); }
  double potential_energy(const Stage& stage) const override;
  double tension() const override { return 4 * sigma_; }

 private:
  double sigma_;
  std::unique_ptr<PressureScheme> scheme_;
  Pressures pressures_;
};

}  // namespace foamsim
