#pragma once

#include <span>

#include "FoamSim/sheet/velocity/tree/chebyshev.h"
#include "FoamSim/sheet/velocity/tree/cluster_tree.h"
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
  /// Half the side of cluster c's box; 1 where it has none.
  double half(std::uint32_t c, std::size_t axis) const { return half_[3 * c + axis]; }

 private:
  std::size_t size_;
  TreeArray<Real> x_, y_, z_;
  std::vector<double> half_;
};

/// Charges of all grids whose interpolants act far away as the points do: the leaves' from points (in the tree's
/// order), the others' from their children.
template <class Real>
TreeArray<Real> gather_charges(const ClusterTree& tree, const GridPoints<Real>& grid, const TreeBodies<Real>& points,
                               const Chebyshev& nodes);

/// Adds to the potentials on all grids (3 arrays a cluster) what their parents' interpolants are there.
void spread_to_children(const ClusterTree& tree, const Chebyshev& nodes, std::span<double> potentials);

/// Adds what the potential's interpolant on cluster c's grid gives to points: itself, its curl, its gradient times the
/// points' strengths.
template <class Real>
void add_interpolated(const GridPoints<Real>& grid, std::uint32_t c, const TreeBodies<Real>& points,
                      const Chebyshev& nodes, const double* potential, TreeTerms terms, double* out,
                      std::size_t stride);

}  // namespace foamsim
