#include "FoamSim/sheet/velocity/tree/tree_sum.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>

#include "Base/error.h"
#include "Base/parallel/for_each.h"
#include "FoamSim/sheet/velocity/tree/cluster_grid.h"
#include "FoamSim/sheet/velocity/tree/cluster_pairs.h"

namespace foamsim {

using lostopos::Vec3;

namespace {

// What lengths and strengths are divided by, so that singles can hold them.
struct TreeUnits {
  double length = 1, strength = 1;
};

std::vector<Vec3> points_of(const VortexSources& sources) {
  std::vector<Vec3> points(sources.size());
  for (std::size_t t = 0; t < points.size(); ++t) points[t] = Vec3(sources.x[t], sources.y[t], sources.z[t]);
  return points;
}

// Points of a tree in its order, each from the middle of its leaf; without strengths unless they take some.
template <class Real>
struct Places {
  TreeArray<Real> x, y, z, gx, gy, gz;

  Places(const ClusterTree& tree, std::span<const Vec3> points, double unit) {
    for (TreeArray<Real>* array : {&x, &y, &z, &gx, &gy, &gz}) array->assign(points.size() + tree_lanes, Real{0});
    for (const Cluster& cluster : tree.clusters())
      for (std::uint32_t i = cluster.begin; cluster.leaf() && i < cluster.end; ++i) {
        const Vec3 place = (points[tree.order()[i]] - cluster.middle) / unit;
        x[i] = static_cast<Real>(place.x());
        y[i] = static_cast<Real>(place.y());
        z[i] = static_cast<Real>(place.z());
      }
  }

  void take_strengths(const ClusterTree& tree, const VortexSources& sources, double unit) {
    for (std::size_t i = 0; i < sources.size(); ++i) {
      gx[i] = static_cast<Real>(sources.gx[tree.order()[i]] / unit);
      gy[i] = static_cast<Real>(sources.gy[tree.order()[i]] / unit);
      gz[i] = static_cast<Real>(sources.gz[tree.order()[i]] / unit);
    }
  }

  TreeBodies<Real> of(const Cluster& c) const {
    const auto at = [&c](const TreeArray<Real>& array) { return array.data() + c.begin; };
    return {at(x), at(y), at(z), at(gx), at(gy), at(gz), c.size()};
  }
};

// Points as near ones and as parts of clusters, and the clusters' grids.
template <class Near, class Far>
struct Side {
  ClusterTree tree;
  Places<Near> near;
  Places<Far> far;
  GridPoints<Far> grid;

  Side(std::span<const Vec3> points, std::size_t leaf_size, const Chebyshev& nodes, const TreeUnits& units)
      : tree(points, leaf_size),
        near(tree, points, units.length),
        far(tree, points, units.length),
        grid(tree, nodes, units.length) {}
};

template <class Near, class Far>
class TreeSum {
 public:
  TreeSum(const Side<Near, Far>& sources, const Side<Near, Far>& targets, const Chebyshev& nodes, double openness,
          double length, double delta, TreeTerms terms)
      : sources_(sources),
        targets_(targets),
        nodes_(nodes),
        length_(length),
        delta_squared_(delta * delta / (length * length)),
        terms_(terms),
        pairs_(targets.tree, sources.tree, openness),
        stride_(targets.far.x.size()),
        out_(components(terms) * stride_, 0.0) {
    charges_ = gather_charges(sources.tree, sources.grid, sources.far.of(Cluster()), nodes);
    potentials_.assign(targets.tree.clusters().size() * 3 * grid_size(nodes), 0.0);
    meet();
    spread_to_children(targets.tree, nodes, potentials_);
    arrive();
  }

  // Component c of target i in the tree's order.
  double value(std::size_t c, std::size_t i) const { return out_[c * stride_ + i]; }

 private:
  bool by_grid(const Cluster& c) const { return c.size() > grid_size(nodes_); }

  TreeBodies<Far> source(std::uint32_t s) const {
    if (!by_grid(sources_.tree[s])) return sources_.far.of(sources_.tree[s]);
    return sources_.grid.bodies(s, charges_.data());
  }

  std::array<double, 3> offset(const Cluster& target, std::uint32_t s) const {
    const Vec3 apart = (target.middle - sources_.tree[s].middle) / length_;
    return {apart.x(), apart.y(), apart.z()};
  }

  void meet() {
    const std::size_t size = grid_size(nodes_);
    base::parallel_for_each(pairs_.far.size(), 1, [&](std::size_t i) {
      const auto t = static_cast<std::uint32_t>(i);
      const Cluster& cluster = targets_.tree[t];
      double* arrived = out_.data() + cluster.begin;
      for (std::uint32_t s : pairs_.far[t])
        if (by_grid(cluster))
          add_to_targets(targets_.grid.bodies(t, nullptr), source(s), offset(cluster, s), delta_squared_,
                         TreeTerms::potential, potentials_.data() + 3 * size * t, size);
        else
          add_to_targets(targets_.far.of(cluster), source(s), offset(cluster, s), delta_squared_, terms_, arrived,
                         stride_);
      for (std::uint32_t s : pairs_.near[t])
        add_to_targets(targets_.near.of(cluster), sources_.near.of(sources_.tree[s]), offset(cluster, s),
                       delta_squared_, terms_, arrived, stride_);
    });
  }

  // From the leaves' grids to their points.
  void arrive() {
    base::parallel_for_each(targets_.tree.clusters().size(), 1, [&](std::size_t i) {
      const auto t = static_cast<std::uint32_t>(i);
      if (!targets_.tree[t].leaf()) return;
      add_interpolated(targets_.grid, t, targets_.far.of(targets_.tree[t]), nodes_,
                       potentials_.data() + 3 * grid_size(nodes_) * t, terms_, out_.data() + targets_.tree[t].begin,
                       stride_);
    });
  }

  const Side<Near, Far>&sources_, &targets_;
  const Chebyshev& nodes_;
  double length_, delta_squared_;
  TreeTerms terms_;
  ClusterPairs pairs_;
  std::size_t stride_;
  TreeArray<Far> charges_;
  std::vector<double> out_, potentials_;
};

template <class Near, class Far>
void sum_up(const VortexSources& sources, const std::span<const Vec3>* targets, const TreeUnits& units, double delta,
            TreeTerms terms, const TreeAccuracy& accuracy, PairSums& result) {
  const Chebyshev nodes(accuracy.nodes);
  const std::size_t leaf = std::max(accuracy.leaf_size, grid_size(nodes));
  Side<Near, Far> from(points_of(sources), leaf, nodes, units);
  from.near.take_strengths(from.tree, sources, units.strength);
  from.far.take_strengths(from.tree, sources, units.strength);
  std::unique_ptr<Side<Near, Far>> own;
  if (targets != nullptr) own = std::make_unique<Side<Near, Far>>(*targets, leaf, nodes, units);
  const Side<Near, Far>& to = own ? *own : from;
  const TreeSum<Near, Far> sum(from, to, nodes, accuracy.openness, units.length, delta, terms);
  const std::size_t n = to.tree.order().size();
  const double scale = std::numbers::inv_pi / 4 * units.strength / units.length;
  const auto fill = [&](std::vector<Vec3>& array, std::size_t first, double unit) {
    array.resize(n);
    base::parallel_for_each(n, 1024, [&](std::size_t i) {
      array[to.tree.order()[i]] = unit * Vec3(sum.value(first, i), sum.value(first + 1, i), sum.value(first + 2, i));
    });
  };
  if (terms != TreeTerms::velocity) fill(result.potential, 0, scale);
  if (terms != TreeTerms::potential) fill(result.velocity, terms == TreeTerms::all ? 3 : 0, scale / units.length);
  if (terms == TreeTerms::all) fill(result.force, 6, scale / units.length * units.strength);
}

TreeUnits tree_units(const VortexSources& sources, double delta) {
  TreeUnits units;
  Vec3 low(sources.x[0], sources.y[0], sources.z[0]), high = low;
  double strongest = 0;
  for (std::size_t t = 0; t < sources.size(); ++t) {
    const Vec3 point(sources.x[t], sources.y[t], sources.z[t]);
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
    strongest = std::max({strongest, std::abs(sources.gx[t]), std::abs(sources.gy[t]), std::abs(sources.gz[t])});
  }
  const double size = (high - low).maxCoeff();
  units.length = delta > 0 ? delta : size > 0 ? size : 1;
  units.strength = strongest > 0 ? strongest : 1;
  return units;
}

}  // namespace

void tree_sum(const VortexSources& sources, const std::span<const Vec3>* targets, double delta, TreeTerms terms,
              const TreeAccuracy& accuracy, PairSums& result) {
  if (!std::isfinite(delta) || delta < 0) throw base::InputError("delta has to be a finite length >= 0");
  result = {};
  const std::size_t n = targets != nullptr ? targets->size() : sources.size();
  if (n == 0 || sources.size() == 0) {
    const std::vector<Vec3> nothing(n, Vec3::Zero());
    if (terms != TreeTerms::velocity) result.potential = nothing;
    if (terms != TreeTerms::potential) result.velocity = nothing;
    if (terms == TreeTerms::all) result.force = nothing;
    return;
  }
  const TreeUnits units = tree_units(sources, delta);
  if (accuracy.single_near && accuracy.single_far)
    sum_up<float, float>(sources, targets, units, delta, terms, accuracy, result);
  else if (accuracy.single_near)
    sum_up<float, double>(sources, targets, units, delta, terms, accuracy, result);
  else
    sum_up<double, double>(sources, targets, units, delta, terms, accuracy, result);
}

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
  accuracy.single_far = tolerance >= 3e-7 * std::sqrt(static_cast<double>(n));
  return accuracy;
}

}  // namespace foamsim
