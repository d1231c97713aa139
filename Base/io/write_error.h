#pragma once

#include <filesystem>
#include <string>

namespace base {

/// Throws what a failure to write is, with the system's reason: DiskError where the disk could not take it (full,
/// quota, limit of file sizes, input/output error), FileError where the path cannot be used. `what`: "cannot write
/// 'a.csv'"; `error`: the system's number, 0 where it gave none; `advice`: added behind a semicolon where the path
/// cannot be used.
[[noreturn]] void throw_write_error(const std::string& what, int error, const std::string& advice = "");

/// Makes a folder and those that it is in, where they are not there yet. Throws as `throw_write_error`.
void make_folder(const std::filesystem::path& folder, const std::string& advice = "");

}  // namespace base
