#include "FoamSim/sheet/velocity/tree/cluster_grid.h"

#include <array>

#include "Base/parallel/for_each.h"

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

template <class Real>
void add_leaf_charges(const GridPoints<Real>& grid, std::uint32_t c, const TreeBodies<Real>& points,
                      const Chebyshev& nodes, Real* charges) {
  const std::size_t n = nodes.size(), plane = n * n;
  std::array<Chebyshev::Values, 3> l{};
  std::array<Real, most_plane> product{};
  for (std::size_t i = 0; i < points.size; ++i) {
    nodes.values(static_cast<double>(points.x[i]) / grid.half(c, 0), l[0]);
    nodes.values(static_cast<double>(points.y[i]) / grid.half(c, 1), l[1]);
    nodes.values(static_cast<double>(points.z[i]) / grid.half(c, 2), l[2]);
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t k = 0; k < n; ++k) product[j * n + k] = static_cast<Real>(l[1][j] * l[2][k]);
    std::size_t component = 0;
    for (Real strength : {points.gx[i], points.gy[i], points.gz[i]}) {
      Real* q = charges + component++ * n * plane;
      for (std::size_t x = 0; x < n; ++x) {
        const Real weight = static_cast<Real>(l[0][x]) * strength;
        for (std::size_t j = 0; j < plane; ++j) q[x * plane + j] += weight * product[j];
      }
    }
  }
}

}  // namespace

template <class Real>
GridPoints<Real>::GridPoints(const ClusterTree& tree, const Chebyshev& nodes, double length)
    : size_(grid_size(nodes)), half_(3 * tree.clusters().size(), 1.0) {
  const std::size_t clusters = tree.clusters().size(), n = nodes.size();
  for (TreeArray<Real>* array : {&x_, &y_, &z_}) array->assign(clusters * size_ + tree_lanes, Real{0});
  base::parallel_for_each(clusters, 16, [&](std::size_t i) {
    const Vec3 half = tree[static_cast<std::uint32_t>(i)].half / length;
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (const double side = half[static_cast<Eigen::Index>(axis)]; side > 0) half_[3 * i + axis] = side;
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
TreeArray<Real> gather_charges(const ClusterTree& tree, const GridPoints<Real>& grid, const TreeBodies<Real>& points,
                               const Chebyshev& nodes) {
  const std::size_t size = grid_size(nodes);
  TreeArray<Real> charges(3 * size * tree.clusters().size(), Real{0});
  const auto levels = tree.levels();
  for (std::size_t level = levels.size() - 1; level-- > 0;)
    base::parallel_ranges(levels[level], levels[level + 1], 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const auto c = static_cast<std::uint32_t>(i);
        const Cluster& cluster = tree[c];
        Real* own = charges.data() + 3 * size * c;
        if (cluster.leaf()) {
          const std::uint32_t b = cluster.begin;
          add_leaf_charges(grid, c,
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
  return charges;
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

template <class Real>
void add_interpolated(const GridPoints<Real>& grid, std::uint32_t c, const TreeBodies<Real>& points,
                      const Chebyshev& nodes, const double* potential, TreeTerms terms, double* out,
                      std::size_t stride) {
  const std::size_t n = nodes.size(), plane = n * n;
  std::array<Chebyshev::Values, 3> value{}, slope{};
  std::array<double, most_plane> sums{}, along{};
  for (std::size_t i = 0; i < points.size; ++i) {
    const std::array<Real, 3> x{points.x[i], points.y[i], points.z[i]};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      nodes.values(static_cast<double>(x[axis]) / grid.half(c, axis), value[axis]);
      nodes.slopes(value[axis], slope[axis]);
      for (std::size_t k = 0; k < n; ++k) slope[axis][k] /= grid.half(c, axis);
    }
    std::array<std::array<double, 4>, 3> got{};  // by component: value, ∂x, ∂y, ∂z
    for (std::size_t part = 0; part < 3; ++part) {
      const double* from = potential + part * n * plane;
      sums.fill(0);
      along.fill(0);
      for (std::size_t a = 0; a < n; ++a) {
        const double weight = value[0][a], tilt = slope[0][a];
        for (std::size_t j = 0; j < plane; ++j) {
          sums[j] += weight * from[a * plane + j];
          along[j] += tilt * from[a * plane + j];
        }
      }
      for (std::size_t b = 0; b < n; ++b) {
        double at = 0, at_x = 0, at_z = 0;
        for (std::size_t d = 0; d < n; ++d) {
          at += value[2][d] * sums[b * n + d];
          at_x += value[2][d] * along[b * n + d];
          at_z += slope[2][d] * sums[b * n + d];
        }
        const double weight = value[1][b];
        got[part][0] += weight * at;
        got[part][1] += weight * at_x;
        got[part][2] += slope[1][b] * at;
        got[part][3] += weight * at_z;
      }
    }
    std::size_t component = 0;
    if (terms != TreeTerms::velocity)
      for (std::size_t part = 0; part < 3; ++part) out[component++ * stride + i] += got[part][0];
    if (terms == TreeTerms::potential) continue;
    out[component++ * stride + i] += got[2][2] - got[1][3];
    out[component++ * stride + i] += got[0][3] - got[2][1];
    out[component++ * stride + i] += got[1][1] - got[0][2];
    if (terms != TreeTerms::all) continue;
    const std::array<double, 3> gamma{points.gx[i], points.gy[i], points.gz[i]};
    for (std::size_t axis = 0; axis < 3; ++axis)
      out[component++ * stride + i] +=
          gamma[0] * got[0][axis + 1] + gamma[1] * got[1][axis + 1] + gamma[2] * got[2][axis + 1];
  }
}

template class GridPoints<double>;
template class GridPoints<float>;
template TreeArray<double> gather_charges(const ClusterTree&, const GridPoints<double>&, const TreeBodies<double>&,
                                          const Chebyshev&);
template TreeArray<float> gather_charges(const ClusterTree&, const GridPoints<float>&, const TreeBodies<float>&,
                                         const Chebyshev&);
template void add_interpolated(const GridPoints<double>&, std::uint32_t, const TreeBodies<double>&, const Chebyshev&,
                               const double*, TreeTerms, double*, std::size_t);
template void add_interpolated(const GridPoints<float>&, std::uint32_t, const TreeBodies<float>&, const Chebyshev&,
                               const double*, TreeTerms, double*, std::size_t);

}  // namespace foamsim
