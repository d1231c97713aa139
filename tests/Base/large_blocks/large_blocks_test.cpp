// A program of its own, and not under the sanitizers, whose memory is another.
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <memory>
#include <vector>

#include "Base/machine/memory.h"

namespace base {
namespace {

// Bytes of the process that are in memory (/proc/self/statm, in pages).
double resident_bytes() {
  std::ifstream file("/proc/self/statm");
  double size = 0, resident = 0;
  file >> size >> resident;
  return static_cast<double>(::sysconf(_SC_PAGESIZE)) * resident;
}

// Large blocks come and go as a mesh's arrays do, each of another size, with small ones that stay between them.
TEST(LargeBlocks, GoBackToTheSystem) {
  give_back_large_blocks();
  constexpr std::size_t blocks = 50, rounds = 4, smallest = 3 << 20;
  const double before = resident_bytes();
  std::vector<std::unique_ptr<int>> small;
  for (std::size_t round = 0; round < rounds; ++round) {
    std::vector<std::vector<char>> large;
    for (std::size_t i = 0; i < blocks; ++i) {
      large.emplace_back(smallest + 4096 * (i + round), char(1));
      small.push_back(std::make_unique<int>(1));
    }
    EXPECT_GT(resident_bytes() - before, 0.9 * blocks * smallest);
  }
  EXPECT_LT(resident_bytes() - before, 0.02 * blocks * smallest);
}

}  // namespace
}  // namespace base
