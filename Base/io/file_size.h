#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace base {

/// Bytes of the longest text that a person writes for a program to read: a scene, a grid, an option file.
inline constexpr std::uintmax_t longest_text_file = 16'000'000;

/// Throws FileError where `file` is not a regular file, or not there, and InputError where it has more bytes than
/// `longest_text_file`; before anything is read. `what` it should be: "scene file".
void require_text_file(const std::filesystem::path& file, const std::string& what);

}  // namespace base
