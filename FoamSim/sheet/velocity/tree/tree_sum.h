#pragma once

#include <span>

#include "FoamSim/sheet/velocity/pair_sums.h"
#include "FoamSim/sheet/velocity/tree/tree_kernel.h"
#include "FoamSim/sheet/velocity/vortex_sources.h"
#include "LosTopos/vec3.h"

namespace foamsim {

inline constexpr double least_tolerance = 1e-8, most_tolerance = 1e-2;

/// How far a tree sum goes.
struct TreeAccuracy {
  std::size_t nodes = 6;      ///< interpolation points along each axis of a cluster, 2 to most_nodes
  double openness = 0.7;      ///< radii over distance, up to which clusters meet as wholes, above 0 and below 1
  std::size_t leaf_size = 0;  ///< most points of a leaf, nodes³ or more; less: as many as that
  bool single_near = true;    ///< points one by one in single precision, for relative errors of 3e-6 and more
  bool single_far = true;     ///< clusters too, for about 3e-7 times the root of the number of points

  /// What keeps the relative error of Ψ, u and B (the largest error over the largest value) below `tolerance`,
  /// least_tolerance to most_tolerance, for `n` points: a node more is worth about a digit, 0.12 of openness too.
  static TreeAccuracy of(double tolerance, std::size_t n);
};

/// Sums of regularised vortices by clusters of sources on clusters of targets: O(n).
///
/// Far clusters meet by their values at Chebyshev points (barycentric Lagrange dual tree traversal: Wang, Krasny and
/// Tlupova 2020; Wilson, Vaughn and Krasny 2021), near points one by one. Derivatives are those of the interpolants.
/// Without targets of their own sources are the targets, and the operator from γ to Ψ is symmetric. Same bits for any
/// number of threads.
///
/// @param sources points m_t (L) and strengths γ (L³/T).
/// @param targets points x (L); null: the sources, with themselves (their own potential γ/(4πδ) is in Ψ).
/// @param delta   δ >= 0 (L).
/// @param result  what `terms` names, one of each a target, in the units of PairSums; the rest is empty. B is 0 for
///                targets that are not the sources, which have no strength.
/// @throws base::InputError when delta is negative or not finite.
void tree_sum(const VortexSources& sources, const std::span<const lostopos::Vec3>* targets, double delta,
              TreeTerms terms, const TreeAccuracy& accuracy, PairSums& result);

}  // namespace foamsim
