#include "FoamSim/sheet/velocity/tree/pair_grid.h"

#include "Base/parallel/for_each.h"

namespace foamsim {

using lostopos::Vec3;

GridTransfers::GridTransfers(const Chebyshev& full) : full_{full.size(), full.size(), full.size()} {
  for (std::size_t nodes = 2; nodes <= full.size(); ++nodes)
    for (std::size_t i = 0; i < full.size(); ++i) Chebyshev(nodes).values(full.node(i), values_[nodes][i]);
}

template <class Real>
PairGrids<Real>::PairGrids(const ClusterTree& tree, const PairOrders& orders, std::size_t order, double length) {
  const std::size_t clusters = tree.clusters().size(), most = orders.nodes(order);
  stride_ = most * most * most;
  std::vector<Chebyshev> nodes;
  for (std::size_t n = 2; n <= most; ++n) nodes.emplace_back(n);
  for (TreeArray<Real>* array : {&x_, &y_, &z_}) array->assign(clusters * stride_ + tree_lanes, Real{0});
  shapes_.resize(clusters);
  base::parallel_for_each(clusters, 16, [&](std::size_t i) {
    const Cluster& cluster = tree[static_cast<std::uint32_t>(i)];
    const Vec3 half = cluster.half / length;
    const GridShape& shape = shapes_[i] = orders.shape(order, cluster.half);
    std::size_t at = i * stride_;
    for (std::size_t a = 0; a < shape[0]; ++a)
      for (std::size_t b = 0; b < shape[1]; ++b)
        for (std::size_t c = 0; c < shape[2]; ++c, ++at) {
          x_[at] = static_cast<Real>(half.x() * nodes[shape[0] - 2].node(a));
          y_[at] = static_cast<Real>(half.y() * nodes[shape[1] - 2].node(b));
          z_[at] = static_cast<Real>(half.z() * nodes[shape[2] - 2].node(c));
        }
  });
}

template <class Real>
TreeBodies<Real> PairGrids<Real>::bodies(std::uint32_t c) const {
  const std::size_t at = c * stride_;
  const Real* q = charges_.empty() ? nullptr : charges_.data() + 3 * at;
  return {x_.data() + at,
          y_.data() + at,
          z_.data() + at,
          q,
          q == nullptr ? q : q + stride_,
          q == nullptr ? q : q + 2 * stride_,
          size(c)};
}

template <class Real>
void PairGrids<Real>::lower_charges(const GridTransfers& transfers, std::span<const Real> full) {
  charges_.assign(3 * stride_ * shapes_.size(), Real{0});
  const std::size_t size = grid_size(transfers.full());
  base::parallel_for_each(shapes_.size(), 16, [&](std::size_t c) {
    const GridShape& shape = shapes_[c];
    const auto matrix = [&](std::size_t axis, std::size_t k, std::size_t i) {
      return transfers.value(shape[axis], i, k);
    };
    for (std::size_t part = 0; part < 3; ++part)
      contract(full.data() + (3 * c + part) * size, transfers.full(), matrix, shape,
               charges_.data() + (3 * c + part) * stride_);
  });
}

template <class Real>
void PairGrids<Real>::raise(const GridTransfers& transfers, std::uint32_t c, const double* potential,
                            double* full) const {
  const GridShape& shape = shapes_[c];
  const auto matrix = [&](std::size_t axis, std::size_t i, std::size_t k) {
    return transfers.value(shape[axis], i, k);
  };
  for (std::size_t part = 0; part < 3; ++part)
    contract(potential + part * stride_, shape, matrix, transfers.full(), full + part * grid_size(transfers.full()));
}

template class PairGrids<double>;
template class PairGrids<float>;

}  // namespace foamsim
