#pragma once

#include <tbb/cache_aligned_allocator.h>

#include <array>
#include <cstddef>
#include <vector>

namespace foamsim {

/// What targets collect, 4π times: Ψ = Σ γ/ρ, u = Σ γ × (x − m)/ρ³, B = −Σ (γ_x·γ) (x − m)/ρ³, ρ² = |x − m|² + δ².
enum class TreeTerms {
  potential,  ///< Ψ: 3 components
  velocity,   ///< u: 3 components
  all         ///< Ψ, u, B: 9 components
};
constexpr std::size_t components(TreeTerms terms) {
  return terms == TreeTerms::all ? 9 : 3;
}

/// Targets may be read in groups of as many, so that arrays have to go on for one less behind the last.
inline constexpr std::size_t tree_lanes = 32;

template <class Real>
using TreeArray = std::vector<Real, tbb::cache_aligned_allocator<Real>>;

/// Points, from a middle of their own, and strengths (γ_x of targets, where B is wanted), one array a component.
template <class Real>
struct TreeBodies {
  const Real *x, *y, *z, *gx, *gy, *gz;
  std::size_t size;
};

/// Adds what every source gives to every target to out[c · stride + t]. `offset` is the targets' middle less the
/// sources': places from a middle nearby keep their digits in single precision. One thread, the best instruction set of
/// the machine; each target's sum runs over the sources in their order, so that its bits depend on nothing else. A
/// source at a target gives no velocity, and with δ = 0 no potential.
void add_to_targets(const TreeBodies<double>& targets, const TreeBodies<double>& sources,
                    const std::array<double, 3>& offset, double delta_squared, TreeTerms terms, double* out,
                    std::size_t stride);
void add_to_targets(const TreeBodies<float>& targets, const TreeBodies<float>& sources,
                    const std::array<double, 3>& offset, double delta_squared, TreeTerms terms, double* out,
                    std::size_t stride);

}  // namespace foamsim
