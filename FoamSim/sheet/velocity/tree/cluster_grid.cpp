#include "FoamSim/sheet/velocity/tree/cluster_grid.h"

#include <array>

#include "Base/parallel/for_each.h"
#include "FoamSim/sheet/velocity/tree/leaf_grid.h"

namespace foamsim {

using lostopos::Vec3;

namespace {

constexpr std::size_t most_plane = most_nodes * most_nodes, most_grid = most_plane * most_nodes;

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

// out[i][j] = Σ_k m(i, k) in[k][j] for n × n matrices and `width` columns, three times, each time with the axes turned:
// all three axes of a grid.
template <class Real, class Matrix>
void contract(const Real* in, std::size_t n, const Matrix& m, Real* out) {
  std::array<Real, most_grid> first{}, second{};
  const std::size_t plane = n * n;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < n; ++k) {
      const Real weight = static_cast<Real>(m(0, i, k));
      for (std::size_t j = 0; j < plane; ++j) first[i * plane + j] += weight * in[k * plane + j];
    }
  for (std::size_t x = 0; x < n; ++x)
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t k = 0; k < n; ++k) {
        const Real weight = static_cast<Real>(m(1, i, k));
        for (std::size_t j = 0; j < n; ++j) second[(x * n + i) * n + j] += weight * first[(x * n + k) * n + j];
      }
  for (std::size_t row = 0; row < plane; ++row)
    for (std::size_t k = 0; k < n; ++k) {
      const Real value = second[row * n + k];
      for (std::size_t i = 0; i < n; ++i) out[row * n + i] += static_cast<Real>(m(2, i, k)) * value;
    }
}

}  // namespace

template <class Real>
GridPoints<Real>::GridPoints(const ClusterTree& tree, const Chebyshev& nodes, double length)
    : size_(grid_size(nodes)), half_(tree.clusters().size(), HalfSides{1, 1, 1}) {
  const std::size_t clusters = tree.clusters().size(), n = nodes.size();
  for (TreeArray<Real>* array : {&x_, &y_, &z_}) array->assign(clusters * size_ + tree_lanes, Real{0});
  base::parallel_for_each(clusters, 16, [&](std::size_t i) {
    const Vec3 half = tree[static_cast<std::uint32_t>(i)].half / length;
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (const double side = half[static_cast<Eigen::Index>(axis)]; side > 0) half_[i][axis] = side;
    std::size_t at = i * size_;
    for (std::size_t a = 0; a < n; ++a)
      for (std::size_t b = 0; b < n; ++b)
        for (std::size_t c = 0; c < n; ++c, ++at) {
          x_[at] = static_cast<Real>(half.x() * nodes.node(a));
          y_[at] = static_cast<Real>(half.y() * nodes.node(b));
          z_[at] = static_cast<Real>(half.z() * nodes.node(c));
        }
  });
}

template <class Real>
void gather_charges(const ClusterTree& tree, const GridPoints<Real>& grid, const TreeBodies<Real>& points,
                    const Chebyshev& nodes, TreeArray<Real>& charges) {
  const std::size_t size = grid_size(nodes);
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
          add_leaf_charges(grid.halves(c),
                           TreeBodies<Real>{points.x + b, points.y + b, points.z + b, points.gx + b, points.gy + b,
                                            points.gz + b, cluster.size()},
                           nodes, own);
          continue;
        }
        for (std::uint32_t child : {cluster.child, cluster.child + 1}) {
          const Transfer matrix = transfer(cluster, tree[child], nodes);
          for (std::size_t part = 0; part < 3; ++part)
            contract(
                charges.data() + 3 * size * child + part * size, nodes.size(),
                [&](std::size_t axis, std::size_t parent, std::size_t k) { return matrix[axis][k][parent]; },
                own + part * size);
        }
      }
    });
}

void spread_to_children(const ClusterTree& tree, const Chebyshev& nodes, std::span<double> potentials) {
  const std::size_t size = grid_size(nodes);
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
                potentials.data() + 3 * size * i + part * size, nodes.size(),
                [&](std::size_t axis, std::size_t k, std::size_t parent) { return matrix[axis][k][parent]; },
                potentials.data() + 3 * size * child + part * size);
        }
      }
    });
}

template class GridPoints<double>;
template class GridPoints<float>;
template void gather_charges(const ClusterTree&, const GridPoints<double>&, const TreeBodies<double>&, const Chebyshev&,
                             TreeArray<double>&);
template void gather_charges(const ClusterTree&, const GridPoints<float>&, const TreeBodies<float>&, const Chebyshev&,
                             TreeArray<float>&);

}  // namespace foamsim
