#pragma once

namespace lostopos {

/// Whether two boxes (or anything with corners `low` and `high`) have a point in common; without branches, for in the
/// broad phase the answer is hard to predict.
template <class Either>
bool overlap(const Either& a, const Either& b) {
  int all = a.low[0] <= b.high[0];
  all &= b.low[0] <= a.high[0];
  all &= a.low[1] <= b.high[1];
  all &= b.low[1] <= a.high[1];
  all &= a.low[2] <= b.high[2];
  all &= b.low[2] <= a.high[2];
  return all != 0;
}

}  // namespace lostopos
