#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace base {

/// Appends `value` in the shortest form that reads back as the same bits ("nan", "inf" included); no locale.
void append_number(std::string& text, double value);
void append_number(std::string& text, std::int64_t value);

/// The number that makes up the whole of `token` (a leading + is allowed), or nothing: not a number, trailing
/// characters, or beyond the range of the type.
std::optional<double> parse_double(std::string_view token);
std::optional<std::int64_t> parse_integer(std::string_view token);

}  // namespace base
