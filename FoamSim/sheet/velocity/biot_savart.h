#pragma once

#include <memory>
#include <span>

#include "FoamSim/sheet/velocity/pair_sums.h"
#include "FoamSim/sheet/velocity/vortex_sources.h"
#include "LosTopos/vec3.h"

namespace foamsim {

/// A way to sum the regularised Biot–Savart law (the kernel of Rosenhead 1930 and Moore 1972)
///
///   u(x) = (1/4π) Σ_t γ_t × (x − m_t) / (|x − m_t|² + δ²)^{3/2}.
///
/// Implementations keep no state between calls; one object may be used from several threads.
class BiotSavart {
 public:
  BiotSavart() = default;
  BiotSavart(const BiotSavart&) = delete;
  BiotSavart& operator=(const BiotSavart&) = delete;
  virtual ~BiotSavart() = default;

  /// Velocity at every target.
  ///
  /// @param sources points m_t (unit L) and strengths γ_t (unit L³/T); none: all velocities are zero.
  /// @param targets points x (unit L); may coincide with sources, a source gives no velocity to its own point, also
  ///                where δ = 0.
  /// @param delta   regularisation δ >= 0 (unit L).
  /// @param out     velocities (unit L/T), as many as targets; must not overlap the inputs.
  /// @throws base::InputError when delta is negative or not finite, or sizes do not agree; nothing is written then.
  ///
  /// All numbers must be finite, and distances from 1e-90 to 1e90 in whatever unit (or zero). Same bits for any
  /// number of threads.
  virtual void velocities(const VortexSources& sources, std::span<const lostopos::Vec3> targets, double delta,
                          std::span<lostopos::Vec3> out) const = 0;

  /// Sums over the sources themselves in the same way: of potentials for energies, and all that the conservative
  /// dynamics want. Directly, unless an implementation has its own; `precision` is that of direct sums.
  virtual std::unique_ptr<PairSummation> pair_sums(Precision precision) const;

 protected:
  /// What every implementation asks of its arguments; throws as velocities() says.
  static void check_arguments(const VortexSources& sources, std::span<const lostopos::Vec3> targets, double delta,
                              std::span<const lostopos::Vec3> out);
};

}  // namespace foamsim
