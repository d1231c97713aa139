#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "FoamSim/conservative/near_field.h"
#include "FoamSim/sheet/velocity/pair_sums.h"

namespace foamsim {

/// The air around films of a given shape, by the potentials φ of docs/method.md "A conservative scheme": what moves,
/// how much energy is in it, and the force that moving the mesh at constant φ would take.
class FilmMotion {
 public:
  /// `delta`: δ > 0, L. `pairs`: sums over pairs of triangles, not null; motions that are evaluated in turn can share
  /// it, and one whose triangles stay where they were for another goes on with the other's clusters.
  FilmMotion(double delta, const NearField& near,
             std::shared_ptr<PairSummation> pairs = std::make_shared<DirectPairSums>())
      : delta_(delta), near_(near), pairs_(std::move(pairs)) {}

  /// Evaluates the sums. `phi`: by entry, L²/T; `positions`: by vertex slot. `terms` is `potential` when only fluxes
  /// and the energy are wanted.
  void evaluate(const FilmConnectivity& films, const FilmShape& shape, std::span<const lostopos::Vec3> positions,
                std::span<const double> phi, PairTerms terms);

  /// f_v^r = −½ ∂K/∂φ_v^r, by entry: volume of region r swept in a unit of time at v, L³/T.
  std::span<const double> flux() const { return flux_; }
  /// K = ½ Σ_t γ_t·Ψ_t over density, L⁵/T².
  double kinetic_energy() const { return kinetic_energy_; }
  /// At the barycentres, L/T; after PairTerms::all.
  std::span<const lostopos::Vec3> velocity() const { return sums_.velocity; }
  /// Γ at the corners and γ, by triangle.
  std::span<const std::array<double, 3>> corner_circulation() const { return corner_circulation_; }
  std::span<const lostopos::Vec3> strength() const { return strength_; }
  std::span<const lostopos::Vec3> potential() const { return sums_.potential; }

  /// Adds h_v = ∂K/∂x_v − G_v for vertices that move with `velocity` (L/T, by vertex slot): the force that keeps K when
  /// the mesh moves at constant φ, L⁴/T². After PairTerms::all.
  void add_inertia(const FilmConnectivity& films, const FilmShape& shape, std::span<const lostopos::Vec3> positions,
                   std::span<const lostopos::Vec3> velocity, std::span<lostopos::Vec3> force) const;

  long evaluations() const { return evaluations_; }

 private:
  double delta_;
  NearField near_;
  std::shared_ptr<PairSummation> pairs_;
  VortexSources sources_;
  PairSums sums_;
  std::vector<std::array<double, 3>> corner_circulation_;
  std::vector<lostopos::Vec3> strength_;
  std::vector<double> flux_;
  double kinetic_energy_ = 0;
  long evaluations_ = 0;
};

/// Hydrodynamic impulse P = Σ 2 Γ̄ N = 2 Σ φ a and its scale Σ |2 Γ̄ N|, L⁴/T.
struct FilmImpulse {
  lostopos::Vec3 total = lostopos::Vec3::Zero();
  double scale = 0;
};
FilmImpulse impulse(const FilmConnectivity& films, const FilmShape& shape, std::span<const double> phi);

}  // namespace foamsim
