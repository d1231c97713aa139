#pragma once

#include <algorithm>
#include <functional>

namespace base {

/// Of neighbours that are equal under `projection` keeps the first: of a sorted list, one of each.
/// Not by std::ranges::unique, whose result clang 14 cannot make from the library of GCC 12.
template <class List, class Projection = std::identity>
void erase_repeated(List& list, Projection projection = {}) {
  const auto equal = [&projection](const auto& a, const auto& b) {
    return std::invoke(projection, a) == std::invoke(projection, b);
  };
  list.erase(std::unique(list.begin(), list.end(), equal), list.end());
}

/// Sorts, and keeps one of each.
template <class List>
void sort_unique(List& list) {
  std::sort(list.begin(), list.end());
  erase_repeated(list);
}

}  // namespace base
