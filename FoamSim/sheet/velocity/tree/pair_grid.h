#pragma once

#include <span>

#include "FoamSim/sheet/velocity/tree/chebyshev.h"
#include "FoamSim/sheet/velocity/tree/cluster_tree.h"
#include "FoamSim/sheet/velocity/tree/contract.h"
#include "FoamSim/sheet/velocity/tree/leaf_grid.h"
#include "FoamSim/sheet/velocity/tree/pair_orders.h"
#include "FoamSim/sheet/velocity/tree/tree_kernel.h"

namespace foamsim {

/// L_k of grids of every size at the nodes of the full one: what takes charges from the full grid to another and
/// potentials back, exactly, for the smaller one's polynomials are among the full one's.
class GridTransfers {
 public:
  explicit GridTransfers(const Chebyshev& full);

  const GridShape& full() const { return full_; }
  /// L_k of `nodes` points at the full grid's i.
  double value(std::size_t nodes, std::size_t i, std::size_t k) const { return values_[nodes][i][k]; }

 private:
  GridShape full_;
  std::array<std::array<Chebyshev::Values, most_nodes>, most_nodes + 1> values_{};
};

/// The grids of one order by which clusters of a tree meet others: places in units of `length` (L) from the clusters'
/// middles, and charges.
template <class Real>
class PairGrids {
 public:
  PairGrids(const ClusterTree& tree, const PairOrders& orders, std::size_t order, double length);

  std::size_t size(std::uint32_t c) const { return grid_size(shapes_[c]); }
  /// Places of a cluster's potentials in an array: 3 a cluster, as many apart.
  std::size_t stride() const { return stride_; }
  /// Cluster c's; with charges after lower_charges.
  TreeBodies<Real> bodies(std::uint32_t c) const;

  /// Takes the charges of the full grids (3 arrays a cluster).
  void lower_charges(const GridTransfers& transfers, std::span<const Real> full);
  /// Adds the interpolant of a potential on cluster c's grid (3 arrays, stride() apart) to that on its full grid.
  void raise(const GridTransfers& transfers, std::uint32_t c, const double* potential, double* full) const;

 private:
  std::size_t stride_;
  std::vector<GridShape> shapes_;
  TreeArray<Real> x_, y_, z_, charges_;
};

}  // namespace foamsim
