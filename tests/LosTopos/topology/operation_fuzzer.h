#pragma once

#include <cstdint>
#include <string>

namespace lostopos::test {

/// What a round of random operations did.
struct FuzzRound {
  std::string failure;  ///< empty: none; else the mesh, what was asked of it and what is wrong with it then
  long done = 0;        ///< operations that changed the mesh
  long refused = 0;     ///< operations that did not, as they had to leave it the same to the bit
};

/// So many operations on a mesh of several bubbles, both drawn from the seed: splits, collapses, flips, smoothing,
/// merges, snaps, separations of vertices, motion at random, squeezing of a neck, compaction. After each the mesh has
/// to be audited as clean, with sound attributes. The same seed gives the same round.
FuzzRound fuzz_operations(std::uint64_t seed, int operations);

}  // namespace lostopos::test
