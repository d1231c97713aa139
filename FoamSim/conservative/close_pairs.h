#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "LosTopos/vec3.h"

namespace foamsim {

/// Which points are close to which, each to itself included: a list for every point, in an order that is the same for
/// any number of threads.
struct ClosePairs {
  std::vector<std::uint32_t> first;  ///< by point + 1, into `other`
  std::vector<std::uint32_t> other;

  std::span<const std::uint32_t> of(std::size_t point) const {
    return {other.data() + first[point], other.data() + first[point + 1]};
  }
};

/// Pairs no farther apart than `distance` (L, > 0), by sorting the points into cubes of that size. Where that would be
/// more than `most` a point on average, the distance is halved, as often as it takes and eight times at the most.
ClosePairs close_pairs(std::span<const lostopos::Vec3> points, double distance, std::size_t most);

}  // namespace foamsim
