#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "FoamSim/sheet/velocity/tree/tree_kernel.h"

namespace foamsim {

/// A vortex at m from its cluster's middle, with the product that all targets need.
struct NearSource {
  float m[3];
  float strength[3];  ///< γ
  float moment[3];    ///< γ × m
};

std::vector<NearSource> near_sources(const TreeBodies<float>& points);

/// Whether add_near_velocities keeps its digits: no target is further from the sources' middle than 64 times the least
/// distance ρ of a target from a source.
///
/// @param apart  between the clusters' middles.
/// @param target largest distance of a target from its cluster's middle.
/// @param source of a source, likewise.
/// @param delta  > 0. All in one unit of length.
bool are_near_enough(double apart, double target, double source, double delta);

/// What add_to_targets adds for TreeTerms::velocity, in three quarters of the time: with x and m from the sources'
/// middle Σ w γ × (x − m) = (Σ w γ) × x − Σ w (γ × m), w = 1/ρ³. The difference is of terms |x|/ρ times as large, and
/// single precision loses as many digits: only for clusters that are_near_enough.
///
/// Same bits as there: of each target's sum, whatever the threads and the width of the vectors.
void add_near_velocities(const TreeBodies<float>& targets, std::span<const NearSource> sources,
                         const std::array<double, 3>& offset, double delta_squared, double* out, std::size_t stride);

}  // namespace foamsim
