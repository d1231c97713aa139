#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace lostopos {

/// Throws InputError "file, line n: problem".
[[noreturn]] void throw_at_line(const std::string& file, std::size_t line, const std::string& problem);

/// Throws InputError "file, byte n: problem"; bytes count from 0.
[[noreturn]] void throw_at_byte(const std::string& file, std::uint64_t offset, const std::string& problem);

/// `text` in quotes for a message: cut to a readable length, unprintable bytes shown as \xNN.
std::string in_quotes(std::string_view text);

}  // namespace lostopos
