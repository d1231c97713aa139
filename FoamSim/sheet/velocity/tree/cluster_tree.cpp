#include "FoamSim/sheet/velocity/tree/cluster_tree.h"

#include <algorithm>
#include <numeric>

namespace foamsim {

using lostopos::Vec3;

namespace {

// Sides of nothing would make interpolants across them worthless.
constexpr double least_side = 0.1;  // of the longest

Cluster cluster_of(std::span<const Vec3> points, std::span<const std::uint32_t> order, std::uint32_t begin,
                   std::uint32_t end) {
  Vec3 low = points[order[begin]], high = low;
  for (std::uint32_t i = begin; i < end; ++i) {
    low = low.cwiseMin(points[order[i]]);
    high = high.cwiseMax(points[order[i]]);
  }
  Vec3 half = (high - low) / 2;
  half = half.cwiseMax(least_side * half.maxCoeff());
  return {.middle = low + (high - low) / 2, .half = half, .radius = half.norm(), .begin = begin, .end = end};
}

// The same box moved inwards where it sticks out of its parent's.
Cluster inside(Cluster cluster, const Cluster& parent) {
  const Vec3 room = parent.half - cluster.half;
  cluster.middle = cluster.middle.cwiseMax(parent.middle - room).cwiseMin(parent.middle + room);
  return cluster;
}

}  // namespace

ClusterTree::ClusterTree(std::span<const Vec3> points, std::size_t leaf_size) : order_(points.size()) {
  std::iota(order_.begin(), order_.end(), 0U);
  levels_.push_back(0);
  if (points.empty()) return;
  clusters_.push_back(cluster_of(points, order_, 0, static_cast<std::uint32_t>(points.size())));
  while (levels_.back() < clusters_.size()) {
    const auto first = levels_.back(), last = static_cast<std::uint32_t>(clusters_.size());
    levels_.push_back(last);
    for (std::uint32_t c = first; c < last; ++c) {
      const Cluster parent = clusters_[c];
      if (parent.size() <= leaf_size || parent.radius == 0) continue;
      Eigen::Index axis = 0;
      parent.half.maxCoeff(&axis);
      const std::uint32_t cut = parent.begin + parent.size() / 2;
      std::nth_element(order_.begin() + parent.begin, order_.begin() + cut, order_.begin() + parent.end,
                       [&](std::uint32_t a, std::uint32_t b) {
                         return points[a][axis] != points[b][axis] ? points[a][axis] < points[b][axis] : a < b;
                       });
      clusters_[c].child = static_cast<std::uint32_t>(clusters_.size());
      clusters_.push_back(inside(cluster_of(points, order_, parent.begin, cut), parent));
      clusters_.push_back(inside(cluster_of(points, order_, cut, parent.end), parent));
    }
  }
}

}  // namespace foamsim
