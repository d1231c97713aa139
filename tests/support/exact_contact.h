#pragma once

namespace lostopos::test {

/// The exact time of a first contact: `low` when the two are equal, else between them.
struct ExactContact {
  double low = 0;
  double high = 0;

  /// For times that the interval was kept apart from.
  bool is_before(double time) const { return low < time && high <= time; }
  bool is_after(double time) const { return high > time && low >= time; }
};

}  // namespace lostopos::test
