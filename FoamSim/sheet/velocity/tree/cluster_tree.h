#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "LosTopos/vec3.h"

namespace foamsim {

/// Points that are next to each other, and the box around them.
struct Cluster {
  lostopos::Vec3 middle, half;       ///< of the box, L; no side is shorter than a tenth of the longest
  double radius = 0;                 ///< of the ball around the box, L
  std::uint32_t begin = 0, end = 0;  ///< its points, as places in ClusterTree::order
  std::uint32_t child = 0;           ///< the first of two, which follow each other; 0: a leaf

  std::uint32_t size() const { return end - begin; }
  bool leaf() const { return child == 0; }
};

/// Points halved again and again across the longest side of their boxes, until `leaf_size` or fewer are together.
/// Level by level: the root first, children behind all of their parents' level.
class ClusterTree {
 public:
  /// `leaf_size` >= 1. No points: no clusters.
  ClusterTree(std::span<const lostopos::Vec3> points, std::size_t leaf_size);

  std::span<const Cluster> clusters() const { return clusters_; }
  const Cluster& operator[](std::uint32_t i) const { return clusters_[i]; }
  /// The points' indices, cluster by cluster.
  std::span<const std::uint32_t> order() const { return order_; }
  /// Level l has the clusters levels()[l] .. levels()[l + 1] − 1.
  std::span<const std::uint32_t> levels() const { return levels_; }

 private:
  std::vector<Cluster> clusters_;
  std::vector<std::uint32_t> order_, levels_;
};

}  // namespace foamsim
