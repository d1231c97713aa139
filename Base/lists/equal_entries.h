#pragma once

#include <algorithm>
#include <span>
#include <vector>

namespace base {

/// The entries of `sorted`, a list in the order of `projection`, for which it is `value`.
/// Not by std::ranges::equal_range, whose result clang 14 cannot make from the library of GCC 12.
template <class T, class Value, class Projection>
std::span<const T> equal_entries(const std::vector<T>& sorted, const Value& value, Projection projection) {
  const auto begin = std::ranges::lower_bound(sorted, value, {}, projection);
  const auto end = std::ranges::upper_bound(begin, sorted.end(), value, {}, projection);
  return {begin, end};
}

}  // namespace base
