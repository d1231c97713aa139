#pragma once

#include <string>

#include "tests/LosTopos/geometry/ccd_queries.h"

namespace lostopos::test {

/// What a run of queries against the exact oracle found.
struct CheckResult {
  long queries = 0;
  long exact_hits = 0;
  long missed = 0;            ///< exact contact, none reported; must be 0
  long false_hits = 0;        ///< reported, no exact contact
  long late = 0;              ///< reported after the exact first contact; must be 0
  long order_dependent = 0;   ///< another answer for another order of the arguments; must be 0
  long malformed = 0;         ///< weights or normal outside their documented ranges; must be 0
  double largest_gap = 0;     ///< largest distance at the reported time over the largest difference of coordinates
  long early = 0;             ///< reported more than 1e-6 before the exact first contact
  std::string first_failure;  ///< of the kinds that must not be: the query, to the last bit

  double false_hit_rate() const { return static_cast<double>(false_hits) / static_cast<double>(queries); }
};

/// Runs `count` queries of one set through the library and the oracle, on all threads: the same queries for any number
/// of them. Prints the counts. `from`: so many of the set come before the first, to whole parts of 32,768.
CheckResult check_against_oracle(Shape shape, bool adversarial, long count, std::uint64_t seed, long from = 0);

}  // namespace lostopos::test
