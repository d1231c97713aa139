#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "LosTopos/remeshing/refusal.h"

namespace lostopos {

enum class Operation { split, collapse, flip, smoothing };
inline constexpr std::size_t operation_count = 4;
const char* name(Operation operation);

/// How often something was done, and how often not for which reason.
struct OperationCounts {
  std::size_t done = 0;
  std::array<std::size_t, refusal_count> refused = {};  ///< indexed by Refusal
  double seconds = 0;                                   ///< wall time, search for candidates included

  void count(std::optional<Refusal> outcome);
  std::size_t refused_in_all() const;
  OperationCounts& operator+=(const OperationCounts& other);
};

/// Edges that a pass has left out of bounds, by the reason why they cannot be mended now.
struct EdgesLeft {
  std::array<std::size_t, refusal_count> refused = {};  ///< indexed by Refusal
  std::size_t sweeps_used_up = 0;                       ///< could be mended, but the pass has ended
  std::size_t total() const;
};

/// What remeshing did. Sums over passes by +=.
struct RemeshStatistics {
  std::array<OperationCounts, operation_count> operations;
  EdgesLeft too_long, too_short;
  std::size_t triangles_out_of_bounds = 0;  ///< by area or angle, at the end
  std::size_t aggressive_rounds = 0;
  double seconds = 0;  ///< wall time in all

  OperationCounts& operator[](Operation o) { return operations[static_cast<std::size_t>(o)]; }
  const OperationCounts& operator[](Operation o) const { return operations[static_cast<std::size_t>(o)]; }
  std::size_t done_in_all() const;
  RemeshStatistics& operator+=(const RemeshStatistics& other);
};

}  // namespace lostopos
