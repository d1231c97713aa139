#include "FoamSim/sheet/velocity/tree/tree_accuracy.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "FoamSim/sheet/velocity/tree/chebyshev.h"

namespace foamsim {

TreeAccuracy TreeAccuracy::of(double tolerance, std::size_t n) {
  // Measured on spheres, flat sheets and clouds of vortices: the error of u with 3 nodes and an openness of 0.6, the
  // digits that a node is worth, and how fast the error's logarithm grows with openness.
  constexpr double error_of_three = 1.7e-2, openness = 0.6, worth = 0.85, growth = 20, most_open = 0.75;
  TreeAccuracy accuracy;
  const double digits = std::log10(error_of_three / tolerance);
  const double more = std::clamp(std::ceil(digits / worth - 1e-9), 0.0, static_cast<double>(most_nodes - 3));
  accuracy.nodes = 3 + static_cast<std::size_t>(more);
  accuracy.openness = std::min(most_open, openness + (worth * more - digits) * std::numbers::ln10 / growth);
  accuracy.single_near = tolerance >= 1e-5;
  accuracy.near_moments = tolerance >= 1e-4;
  accuracy.single_far = tolerance >= 8e-8 * std::sqrt(static_cast<double>(n));
  return accuracy;
}

}  // namespace foamsim
