#pragma once

#include <filesystem>

namespace fuzz {

/// Writes small files for every harness to begin with, into `folder`/NAME. Throws base::Error where that fails.
void write_corpus(const std::filesystem::path& folder);

}  // namespace fuzz
