#pragma once

#include <span>
#include <vector>

#include "FoamSim/sheet/velocity/tree/chebyshev.h"
#include "FoamSim/sheet/velocity/tree/cluster_tree.h"
#include "FoamSim/sheet/velocity/tree/leaf_grid.h"
#include "FoamSim/sheet/velocity/tree/tree_kernel.h"

namespace foamsim {

/// Points of a cluster's full grid: the tensor product of the nodes along its box, x outermost.
inline std::size_t grid_size(const Chebyshev& nodes) {
  return nodes.size() * nodes.size() * nodes.size();
}

/// Of all clusters, in units of `length` (L).
std::vector<HalfSides> half_sides(const ClusterTree& tree, double length);

/// Charges of all full grids whose interpolants act far away as the points do: the leaves' from points (in the tree's
/// order), the others' from their children; 3 arrays a cluster.
template <class Real>
void gather_charges(const ClusterTree& tree, std::span<const HalfSides> half, const TreeBodies<Real>& points,
                    const Chebyshev& nodes, TreeArray<Real>& charges);

/// Adds to the potentials on all full grids (3 arrays a cluster) what their parents' interpolants are there.
void spread_to_children(const ClusterTree& tree, const Chebyshev& nodes, std::span<double> potentials);

}  // namespace foamsim
