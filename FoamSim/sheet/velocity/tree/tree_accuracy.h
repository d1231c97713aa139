#pragma once

#include <cstddef>

namespace foamsim {

inline constexpr double least_tolerance = 1e-8, most_tolerance = 1e-2;

/// How far a tree sum goes.
struct TreeAccuracy {
  std::size_t nodes = 6;     ///< interpolation points along each axis of a cluster, 2 to most_nodes
  double openness = 0.7;     ///< radii over distance, up to which clusters meet as wholes, above 0 and below 1
  bool single_near = true;   ///< points one by one in single precision, for relative errors of 3e-6 and more
  bool near_moments = true;  ///< velocities of those by add_near_velocities, for 3e-5 and more
  bool single_far = true;    ///< clusters too, for 8e-8 times the root of the number of points and more

  /// What keeps the relative error of Ψ, u and B (the largest error over the largest value) below `tolerance`,
  /// least_tolerance to most_tolerance, for `n` points: a node more is worth about a digit, 0.12 of openness too.
  static TreeAccuracy of(double tolerance, std::size_t n);

  bool operator==(const TreeAccuracy&) const = default;
};

}  // namespace foamsim
