#include "Base/lists/disjoint_sets.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace base {
namespace {

TEST(DisjointSets, AreWhatIsUnited) {
  constexpr std::size_t n = 200;
  DisjointSets sets(n);
  std::vector<std::size_t> least(n);  // relabelled whole at every step
  for (std::size_t i = 0; i < n; ++i) least[i] = i;
  std::mt19937 random(3);
  for (int step = 0; step < 150; ++step) {
    const std::size_t i = random() % n, j = random() % n;
    sets.unite(i, j);
    const std::size_t a = least[i], b = least[j];
    for (std::size_t& label : least)
      if (label == std::max(a, b)) label = std::min(a, b);
    for (std::size_t k = 0; k < n; ++k) ASSERT_EQ(sets.find(k), least[k]) << "after step " << step;
  }
}

}  // namespace
}  // namespace base
