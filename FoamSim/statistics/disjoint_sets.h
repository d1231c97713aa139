#pragma once

#include <cstddef>
#include <numeric>
#include <vector>

namespace foamsim {

/// Sets of the numbers 0 to n − 1, each alone at first, that are united two by two (Tarjan 1975, with path halving).
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), std::size_t{0}); }

  /// The number that stands for the set of i: its least.
  std::size_t find(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void unite(std::size_t i, std::size_t j) {
    i = find(i);
    j = find(j);
    if (i < j)
      parent_[j] = i;
    else
      parent_[i] = j;
  }

 private:
  std::vector<std::size_t> parent_;
};

}  // namespace foamsim
