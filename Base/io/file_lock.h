#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace base {

/// An exclusive lock on a file, which is made where it is not there and stays. The system takes it back when the
/// process that holds it ends, in whatever way; processes that inherit `descriptor()` hold it as well.
class FileLock {
 public:
  /// The lock, or nothing where another process holds it. Throws FileError where the file cannot be made. On a file
  /// system without locks everybody gets it. Whoever holds the lock may remove the file.
  static std::optional<FileLock> take(const std::filesystem::path& file);
  FileLock(FileLock&& other) noexcept;
  FileLock& operator=(FileLock&&) = delete;
  ~FileLock();

  int descriptor() const { return descriptor_; }
  /// Writes into the file who holds the lock, for `signature_in`.
  void sign() const;

 private:
  explicit FileLock(int descriptor) : descriptor_(descriptor) {}
  int descriptor_;  // closed on exec unless a process is started with it; -1: moved from
};

/// "process 4711 on node3": who has signed a lock's file; empty where nobody has.
std::string signature_in(const std::filesystem::path& file);

}  // namespace base
