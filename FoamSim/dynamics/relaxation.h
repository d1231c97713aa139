#pragma once

#include "FoamSim/dynamics/dynamics.h"

namespace foamsim {

/// Films without air: every vertex goes down the gradient of the films' energy, at a speed of force over area, until
/// the foam is in equilibrium. A step solves
///
///   (A/dt + T L) d = −∂E/∂x + Σ_r p_r ∂V_r/∂x
///
/// for the displacements d, A the vertices' areas (a third of the triangles around each), T the films' tension and L
/// their cotangent Laplacian, for which T L x is ∂E/∂x of films: implicit mean curvature flow (Desbrun et al. 1999),
/// stable for any dt. p are the pressures in the closed bubbles that balance the most of ∂E/∂x; they keep volumes to
/// first order, and the effect `volumes` sees to the rest. What of a displacement is longer than `longest_motion` edges
/// is left for the next step. For the start of foams, and for equilibria; time has no physical meaning.
class Relaxation final : public Dynamics {
 public:
  static constexpr double longest_motion = 0.3;  ///< of a vertex in a step, over h̄
  static constexpr long most_iterations = 500;   ///< of the linear solver, which then takes what it has

  double attach(lostopos::SurfaceMesh& mesh, const DynamicsStart& start) override;
  bool remeshes_start() const override { return true; }
  /// Twice the time in which a wave of the length of an edge dies away.
  double suitable_dt(const EffectStep& step, double tension) override;
  bool needs_held_edges() const override { return true; }
  bool takes_tension() const override { return true; }
  AirState air(const EffectStep& /*step*/, CirculationField& /*circulation*/) override { return {}; }
  void before_burst(const EffectStep& /*step*/, CirculationField& /*circulation*/,
                    lostopos::Region /*region*/) override {}
  void advance(StepScope& scope, std::vector<lostopos::Vec3>& predicted) override;

 private:
  double resolution_ = 0;
};

}  // namespace foamsim
