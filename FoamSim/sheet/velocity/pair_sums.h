#pragma once

#include <span>
#include <vector>

#include "Base/parallel/ranks.h"
#include "FoamSim/sheet/velocity/pair_kernel.h"
#include "FoamSim/sheet/velocity/vortex_sources.h"
#include "LosTopos/vec3.h"

namespace foamsim {

/// What the triangles' vortices do to each other, at their barycentres m_t (docs/method.md "A conservative scheme"):
///
///   Ψ_t = (1/4π) Σ_s γ_s / ρ_ts                       potential, s = t included, L²/T
///   B_t = −(1/4π) Σ_s (γ_t·γ_s) (m_t − m_s) / ρ_ts³   ∂K/∂m_t at constant strengths, L⁴/T²
///   u_t = (1/4π) Σ_s γ_s × (m_t − m_s) / ρ_ts³        velocity, L/T
///
/// with ρ_ts² = |m_t − m_s|² + δ².
struct PairSums {
  std::vector<lostopos::Vec3> potential;  ///< Ψ
  std::vector<lostopos::Vec3> force;      ///< B; empty unless asked for
  std::vector<lostopos::Vec3> velocity;   ///< u; empty unless asked for
};

/// What pairs are added up in.
enum class Precision {
  doubles,
  singles,   ///< in half of the time; relative errors of about 1e-6, and the sums are as symmetric as before
  automatic  ///< singles from `many_triangles` on, where the error of any mesh is hundreds of times larger
};
inline constexpr std::size_t many_triangles = 4096;

enum class PairTerms {
  potential,  ///< Ψ alone
  all         ///< Ψ, B and u
};

/// A way to sum them. Keeps work arrays between calls, so that one object serves one thread.
class PairSummation {
 public:
  PairSummation() = default;
  PairSummation(const PairSummation&) = delete;
  PairSummation& operator=(const PairSummation&) = delete;
  virtual ~PairSummation() = default;

  /// @param sources barycentres (L) and strengths γ (L³/T); distances from 1e-90 to 1e90, or zero.
  /// @param delta   δ > 0 (L).
  /// @throws base::InputError when delta is not a finite length > 0.
  virtual void evaluate(const VortexSources& sources, double delta, PairTerms terms, PairSums& sums) = 0;
};

/// Sums over all pairs of triangles, each pair visited once for both of its members: O(n²).
///
/// SIMD with run-time choice of the instruction set; pairs are shared out among a fixed number of groups, whose sums
/// are added up in a fixed order: same bits for any number of threads, and for any instruction set that has fused
/// multiplication (AVX2, AVX-512, NEON).
class DirectPairSums final : public PairSummation {
 public:
  /// `ranks`: share out the groups.
  explicit DirectPairSums(Precision precision = Precision::doubles,
                          std::shared_ptr<const base::Ranks> ranks = base::alone())
      : precision_(precision), ranks_(std::move(ranks)) {}

  void evaluate(const VortexSources& sources, double delta, PairTerms terms, PairSums& sums) override;

 private:
  // Works out sums of the padded bodies into totals_.
  template <class Real>
  void add_up(const PairBodies<Real>& bodies, double delta_squared, PairTerms terms);

  Precision precision_;
  std::shared_ptr<const base::Ranks> ranks_;
  PairBodies<double> doubles_;
  PairBodies<float> singles_;
  // Of each of this rank's groups, and of all: one array a component, one after the other.
  std::vector<PairBodies<double>::Array> parts_;
  PairBodies<double>::Array totals_;
};

}  // namespace foamsim
