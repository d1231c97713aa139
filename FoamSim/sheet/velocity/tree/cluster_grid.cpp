#include "FoamSim/sheet/velocity/tree/cluster_grid.h"

#include <array>

#include "Base/parallel/for_each.h"
#include "FoamSim/sheet/velocity/tree/contract.h"
#include "FoamSim/sheet/velocity/tree/leaf_grid.h"

namespace foamsim {

using lostopos::Vec3;

namespace {

// L_k of the parent's nodes at the child's, by axis: [axis][child's][parent's].
using Transfer = std::array<std::array<Chebyshev::Values, most_nodes>, 3>;

Transfer transfer(const Cluster& parent, const Cluster& child, const Chebyshev& nodes) {
  Transfer matrix{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<Eigen::Index>(axis);
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      const double x = child.middle[a] + child.half[a] * nodes.node(k);
      const double s = parent.half[a] > 0 ? (x - parent.middle[a]) / parent.half[a] : 0.0;
      nodes.values(s, matrix[axis][k]);
    }
  }
  return matrix;
}

}  // namespace

std::vector<HalfSides> half_sides(const ClusterTree& tree, double length) {
  std::vector<HalfSides> sides(tree.clusters().size(), HalfSides{1, 1, 1});
  for (std::size_t c = 0; c < sides.size(); ++c)
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (const double side = tree.clusters()[c].half[static_cast<Eigen::Index>(axis)] / length; side > 0)
        sides[c][axis] = side;
  return sides;
}

template <class Real>
void gather_charges(const ClusterTree& tree, std::span<const HalfSides> half, const TreeBodies<Real>& points,
                    const Chebyshev& nodes, TreeArray<Real>& charges) {
  const std::size_t size = grid_size(nodes);
  const GridShape shape{nodes.size(), nodes.size(), nodes.size()};
  charges.assign(3 * size * tree.clusters().size(), Real{0});
  const auto levels = tree.levels();
  for (std::size_t level = levels.size() - 1; level-- > 0;)
    base::parallel_ranges(levels[level], levels[level + 1], 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const auto c = static_cast<std::uint32_t>(i);
        const Cluster& cluster = tree[c];
        Real* own = charges.data() + 3 * size * c;
        if (cluster.leaf()) {
          const std::uint32_t b = cluster.begin;
          add_leaf_charges(half[c],
                           TreeBodies<Real>{points.x + b, points.y + b, points.z + b, points.gx + b, points.gy + b,
                                            points.gz + b, cluster.size()},
                           nodes, own);
          continue;
        }
        for (std::uint32_t child : {cluster.child, cluster.child + 1}) {
          const Transfer matrix = transfer(cluster, tree[child], nodes);
          for (std::size_t part = 0; part < 3; ++part)
            contract(
                charges.data() + 3 * size * child + part * size, shape,
                [&](std::size_t axis, std::size_t parent, std::size_t k) { return matrix[axis][k][parent]; }, shape,
                own + part * size);
        }
      }
    });
}

void spread_to_children(const ClusterTree& tree, const Chebyshev& nodes, std::span<double> potentials) {
  const std::size_t size = grid_size(nodes);
  const GridShape shape{nodes.size(), nodes.size(), nodes.size()};
  const auto levels = tree.levels();
  for (std::size_t level = 0; level + 1 < levels.size(); ++level)
    base::parallel_ranges(levels[level], levels[level + 1], 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const Cluster& cluster = tree[static_cast<std::uint32_t>(i)];
        if (cluster.leaf()) continue;
        for (std::uint32_t child : {cluster.child, cluster.child + 1}) {
          const Transfer matrix = transfer(cluster, tree[child], nodes);
          for (std::size_t part = 0; part < 3; ++part)
            contract(
                potentials.data() + 3 * size * i + part * size, shape,
                [&](std::size_t axis, std::size_t k, std::size_t parent) { return matrix[axis][k][parent]; }, shape,
                potentials.data() + 3 * size * child + part * size);
        }
      }
    });
}

template void gather_charges(const ClusterTree&, std::span<const HalfSides>, const TreeBodies<double>&,
                             const Chebyshev&, TreeArray<double>&);
template void gather_charges(const ClusterTree&, std::span<const HalfSides>, const TreeBodies<float>&, const Chebyshev&,
                             TreeArray<float>&);

}  // namespace foamsim
