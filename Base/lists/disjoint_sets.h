#pragma once

#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <cstddef>
#include <numeric>

namespace base {

/// Sets of the numbers 0 to n − 1, each alone at first, that are united two by two (Tarjan 1975, with path halving). A
/// few dozen of them take no memory from the heap.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), std::size_t{0}); }

  /// The number that stands for the set of i: its least.
  std::size_t find(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];  // ends: parents descend
    return i;
  }
  void unite(std::size_t i, std::size_t j) {
    i = find(i);
    j = find(j);
    parent_[std::max(i, j)] = std::min(i, j);
  }

 private:
  boost::container::small_vector<std::size_t, 32> parent_;
};

}  // namespace base
