#include "LosTopos/remeshing/remesh_statistics.h"

#include <functional>
#include <numeric>

namespace lostopos {
namespace {

using Counts = std::array<std::size_t, refusal_count>;

void add(Counts& sum, const Counts& other) {
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += other[i];
}

std::size_t sum(const Counts& counts) {
  return std::reduce(counts.begin(), counts.end());
}

void add(EdgesLeft& sum, const EdgesLeft& other) {
  add(sum.refused, other.refused);
  sum.sweeps_used_up += other.sweeps_used_up;
}

}  // namespace

const char* name(Operation operation) {
  switch (operation) {
    case Operation::split:
      return "split";
    case Operation::collapse:
      return "collapse";
    case Operation::flip:
      return "flip";
    case Operation::smoothing:
      return "smoothing";
  }
  return "unknown operation";
}

void OperationCounts::count(std::optional<Refusal> outcome) {
  if (outcome)
    ++refused[static_cast<std::size_t>(*outcome)];
  else
    ++done;
}

std::size_t OperationCounts::refused_in_all() const {
  return sum(refused);
}

OperationCounts& OperationCounts::operator+=(const OperationCounts& other) {
  done += other.done;
  add(refused, other.refused);
  seconds += other.seconds;
  return *this;
}

std::size_t EdgesLeft::total() const {
  return sum(refused) + sweeps_used_up;
}

std::size_t RemeshStatistics::done_in_all() const {
  std::size_t done = 0;
  for (const OperationCounts& counts : operations) done += counts.done;
  return done;
}

RemeshStatistics& RemeshStatistics::operator+=(const RemeshStatistics& other) {
  for (std::size_t i = 0; i < operations.size(); ++i) operations[i] += other.operations[i];
  add(too_long, other.too_long);
  add(too_short, other.too_short);
  triangles_out_of_bounds += other.triangles_out_of_bounds;
  aggressive_rounds += other.aggressive_rounds;
  seconds += other.seconds;
  return *this;
}

}  // namespace lostopos
