// Rounds of random operations on meshes of several bubbles for an hour, or as many seconds as the environment variable
// FOAMSIM_FUZZ_SECONDS says. FOAMSIM_FUZZ_SEED is the first round's seed, which each round after it raises by one; a
// failure names the seed, and with that seed it is the first round again.
#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "tests/LosTopos/topology/operation_fuzzer.h"

namespace lostopos::test {
namespace {

unsigned long number_from_environment(const char* name, unsigned long otherwise) {
  const char* text = std::getenv(name);
  return text != nullptr ? std::stoul(text) : otherwise;
}

TEST(OperationFuzzLong, LeavesSoundMeshes) {
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::seconds(number_from_environment("FOAMSIM_FUZZ_SECONDS", 3600));
  std::uint64_t seed = number_from_environment("FOAMSIM_FUZZ_SEED", 1000);
  long rounds = 0, done = 0, refused = 0, failures = 0;
  constexpr long most_failures = 10;
  do {
    std::printf("seed %llu\n", static_cast<unsigned long long>(seed));  // in case that the program does not come back
    std::fflush(stdout);
    const FuzzRound round = fuzz_operations(seed++, 200);
    ++rounds;
    done += round.done;
    refused += round.refused;
    if (!round.failure.empty()) ++failures;
    EXPECT_EQ(round.failure, "");
  } while (Clock::now() < end && failures < most_failures);
  std::printf("%ld rounds: %ld operations done, %ld refused, %ld rounds failed\n", rounds, done, refused, failures);
}

}  // namespace
}  // namespace lostopos::test
