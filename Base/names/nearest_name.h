#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "Base/error.h"

namespace base {

/// The name in `known` with the smallest edit distance to `name`, or empty when none is near enough to be meant.
std::string nearest_name(std::string_view name, std::span<const std::string_view> known);

/// At most `most` names near enough to be meant, the nearest first.
std::vector<std::string> nearest_names(std::string_view name, std::span<const std::string_view> known,
                                       std::size_t most);

/// "unknown KIND 'NAME'; did you mean 'X' or 'Y'? (known: a, b, c)": with the whole list where it is short, and where
/// `listed_by` gives a command that prints it, "(see 'COMMAND')" instead.
std::string unknown_name_message(std::string_view kind, std::string_view name, std::span<const std::string_view> known,
                                 std::string_view listed_by = {});

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
