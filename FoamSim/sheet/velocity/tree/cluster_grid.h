#pragma once

#include <span>

#include "FoamSim/sheet/velocity/tree/chebyshev.h"
#include "FoamSim/sheet/velocity/tree/cluster_tree.h"
#include "FoamSim/sheet/velocity/tree/leaf_grid.h"
#include "FoamSim/sheet/velocity/tree/tree_kernel.h"

namespace foamsim {

/// Points of a cluster's grid: the tensor product of the nodes along its box, x outermost.
inline std::size_t grid_size(const Chebyshev& nodes) {
  return nodes.size() * nodes.size() * nodes.size();
}

/// The grids of all clusters of a tree, and places in units of `length` (L) from the clusters' middles.
template <class Real>
class GridPoints {
 public:
  GridPoints(const ClusterTree& tree, const Chebyshev& nodes, double length);

  /// Cluster c's, with charges (3 arrays a cluster) where there are any.
  TreeBodies<Real> bodies(std::uint32_t c, const Real* charges) const {
    const std::size_t at = c * size_;
    const Real* q = charges == nullptr ? nullptr : charges + 3 * at;
    return {x_.data() + at,
            y_.data() + at,
            z_.data() + at,
            q,
            q == nullptr ? q : q + size_,
            q == nullptr ? q : q + 2 * size_,
            size_};
  }
  const HalfSides& halves(std::uint32_t c) const { return half_[c]; }

 private:
  std::size_t size_;
  TreeArray<Real> x_, y_, z_;
  std::vector<HalfSides> half_;
};

/// Charges of all grids whose interpolants act far away as the points do: the leaves' from points (in the tree's
/// order), the others' from their children; 3 arrays a cluster.
template <class Real>
void gather_charges(const ClusterTree& tree, const GridPoints<Real>& grid, const TreeBodies<Real>& points,
                    const Chebyshev& nodes, TreeArray<Real>& charges);

/// Adds to the potentials on all grids (3 arrays a cluster) what their parents' interpolants are there.
void spread_to_children(const ClusterTree& tree, const Chebyshev& nodes, std::span<double> potentials);

}  // namespace foamsim
