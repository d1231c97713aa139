#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "Base/error.h"

namespace base {

/// The name in `known` with the smallest edit distance to `name`, or empty when none is near enough to be meant.
std::string nearest_name(std::string_view name, std::span<const std::string_view> known);

/// "unknown KIND 'NAME'; did you mean 'X'? (known: a, b, c)"
std::string unknown_name_message(std::string_view kind, std::string_view name, std::span<const std::string_view> known);

/// The entry of a registry with the given `name` member. Throws InputError with the nearest name.
template <class Range>
const auto& find_by_name(const Range& entries, std::string_view name, std::string_view kind) {
  std::vector<std::string_view> known;
  for (const auto& entry : entries) {
    if (entry.name == name) return entry;
    known.push_back(entry.name);
  }
  throw InputError(unknown_name_message(kind, name, known));
}

}  // namespace base
