#include "FoamSim/sheet/velocity/tree/cluster_pairs.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace foamsim {

namespace {

using Pair = std::pair<std::uint32_t, std::uint32_t>;

// Whether the first is taken apart rather than the second: the larger one, in whatever order they come.
bool opens_first(const ClusterTree& targets, const ClusterTree& sources, const Pair& pair) {
  const Cluster &t = targets[pair.first], &s = sources[pair.second];
  if (t.leaf() || s.leaf()) return s.leaf();
  return t.radius != s.radius ? t.radius > s.radius : pair.first < pair.second;
}

}  // namespace

ClusterPairs::ClusterPairs(const ClusterTree& targets, const ClusterTree& sources, const PairOrders& orders)
    : far(targets.clusters().size()), near(targets.clusters().size()) {
  if (targets.clusters().empty() || sources.clusters().empty()) return;
  std::vector<Pair> open{{0, 0}};
  while (!open.empty()) {
    const Pair pair = open.back();
    open.pop_back();
    const Cluster &t = targets[pair.first], &s = sources[pair.second];
    const double radii = t.radius + s.radius, distance = (t.middle - s.middle).norm();
    if (radii <= orders.most_open() * distance) {
      const double share = distance > 0 ? radii / distance : 0;
      far[pair.first].push_back({pair.second, static_cast<std::uint32_t>(orders.order(share))});
    } else if (t.leaf() && s.leaf()) {
      near[pair.first].push_back(pair.second);
    } else if (&t == &s) {
      for (std::uint32_t i : {0U, 1U})
        for (std::uint32_t j : {0U, 1U}) open.emplace_back(t.child + i, s.child + j);
    } else if (opens_first(targets, sources, pair)) {
      open.emplace_back(t.child, pair.second);
      open.emplace_back(t.child + 1, pair.second);
    } else {
      open.emplace_back(pair.first, s.child);
      open.emplace_back(pair.first, s.child + 1);
    }
  }
}

ClusterPairs ClusterPairs::of_leaves(const ClusterTree& targets, const ClusterTree& sources) {
  ClusterPairs pairs(targets.clusters().size());
  std::vector<std::uint32_t> leaves;
  for (std::uint32_t s = 0; s < sources.clusters().size(); ++s)
    if (sources[s].leaf()) leaves.push_back(s);
  for (std::uint32_t t = 0; t < targets.clusters().size(); ++t)
    if (targets[t].leaf()) pairs.near[t] = leaves;
  return pairs;
}

double ClusterPairs::cost(const ClusterTree& targets, const ClusterTree& sources, const PairOrders& orders) const {
  // Of a cluster: its charges and potentials, up, down and to its points, for each node of the finest grid (measured).
  constexpr double own = 500;
  const auto nodes = [&orders](std::size_t order) { return std::pow(static_cast<double>(orders.nodes(order)), 3); };
  double sum =
      own * nodes(orders.count() - 1) * static_cast<double>(targets.clusters().size() + sources.clusters().size());
  for (std::uint32_t t = 0; t < targets.clusters().size(); ++t) {
    const double size = targets[t].size();
    for (const std::uint32_t s : near[t]) sum += size * sources[s].size();
    for (const Far& met : far[t])
      sum += std::min(size, nodes(met.order)) * std::min<double>(sources[met.source].size(), nodes(met.order));
  }
  return sum;
}

}  // namespace foamsim
