#pragma once

#include <cstddef>
#include <vector>

#include "FoamSim/sheet/velocity/tree/contract.h"
#include "FoamSim/sheet/velocity/tree/tree_accuracy.h"
#include "LosTopos/vec3.h"

namespace foamsim {

/// How fine the grids have to be by which two clusters meet. The interpolant of 1/ρ with n points across an interval of
/// half-length h whose nearest source is s h from its middle is wrong by about r^(n − 1), r = 1/(s + √(s² − 1))
/// (Bernstein's ellipse; Trefethen 2013, chapter 8), its slope included: clusters farther apart than the accuracy's
/// openness need fewer points than its nodes, and so do the short sides of their boxes.
class PairOrders {
 public:
  explicit PairOrders(const TreeAccuracy& accuracy);

  /// An order for each number of nodes from 3 (or all, where those are fewer) on.
  std::size_t count() const { return reach_.size(); }
  std::size_t nodes(std::size_t order) const { return fewest_ + order; }
  /// Up to which radii over distance clusters meet as wholes.
  double most_open() const { return reach_.back(); }
  /// The lowest one for a pair of clusters whose radii are this share of their middles' distance.
  std::size_t order(double openness) const;
  /// The grid of an order for a cluster with a box of these half sides (L).
  GridShape shape(std::size_t order, const lostopos::Vec3& half) const;

 private:
  std::size_t fewest_;
  std::vector<double> reach_;  // by order, rising: the largest openness that it is good enough for
};

}  // namespace foamsim
