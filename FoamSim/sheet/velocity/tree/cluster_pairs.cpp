#include "FoamSim/sheet/velocity/tree/cluster_pairs.h"

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

}  // namespace foamsim
