#pragma once

#include "FoamSim/dynamics/integrator.h"

namespace foamsim {

/// Bounds on the rounds of `implicit` and `pbd`, and on |δ| (L²/T, root of the sum of squares) at which they end.
inline constexpr long most_implicit_rounds = 100;
inline constexpr double implicit_tolerance = 1e-8;
/// Largest number of circulations that `pbd` is for: a round's cost grows with its square, a dozen kernels each.
inline constexpr long most_pbd_unknowns = 3000;

/// Tension acts implicitly on circulation: ΔΓ = dt σ (H^p − H^q)(x + dt u(Γ + ΔΓ)), see ImplicitTension, by Newton's
/// method with GMRES for its linear systems; then Γ + ΔΓ moves the vertices as with Euler. Bears any step, and damps
/// what the step does not resolve. Where the iteration gains nothing in five rounds, it ends with the least residual
/// and counts as not solved. It drives films with twice their explicit curvature, see SineCurvature, as the published
/// program does.
class Implicit : public Integrator {
 public:
  bool takes_tension() const override { return true; }
  long kick(const CirculationKick& kick) override;
  void advance(double dt, std::span<const lostopos::Vec3> x, std::span<const lostopos::Vec3> u,
               const StageMotion& motion, std::vector<lostopos::Vec3>& predicted) override;
};

/// The same equation by projections as in position-based dynamics: every row i asks for the correction −C_i J_i /
/// |J_i|², all at once and summed. Converges where rows overlap little, that is for steps near the explicit limit and
/// below; elsewhere it ends at the bound on its rounds, or throws base::Error where it runs away. Throws
/// base::InputError for surfaces with more than most_pbd_unknowns circulations.
class PositionBased final : public Implicit {
 public:
  long kick(const CirculationKick& kick) override;
};

}  // namespace foamsim
