#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>

namespace fuzz {

/// A file that is in memory only.
class MemoryFile {
 public:
  explicit MemoryFile(std::span<const std::uint8_t> bytes);
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  ~MemoryFile();
  /// A name under which it can be opened, without an extension.
  std::filesystem::path path() const;

 private:
  int descriptor_;
};

/// Reads a file of these bytes with `read`; false for an InputError, which is what a reader may answer. Other
/// exceptions pass through.
bool read_file(std::span<const std::uint8_t> bytes, const std::function<void(const std::filesystem::path&)>& read);

}  // namespace fuzz
