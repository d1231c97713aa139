// Rounds of random operations on meshes of several bubbles, from fixed seeds.
#include <gtest/gtest.h>

#include "tests/LosTopos/topology/operation_fuzzer.h"

namespace lostopos::test {
namespace {

TEST(OperationFuzz, LeavesSoundMeshes) {
  long done = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const FuzzRound round = fuzz_operations(seed, 60);
    EXPECT_EQ(round.failure, "");
    done += round.done;
  }
  EXPECT_GT(done, 50);
}

}  // namespace
}  // namespace lostopos::test
