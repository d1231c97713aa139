#pragma once

#include <filesystem>
#include <string>

namespace foamsim::web {

/// The bytes of a file. Throws base::FileError where it cannot be read.
std::string read_text(const std::filesystem::path& file);

}  // namespace foamsim::web
