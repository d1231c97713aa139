#pragma once

#include <filesystem>
#include <memory>
#include <ostream>

namespace base {

/// What a committed file outlives: the end of its program, or that of the machine as well, for which `commit` waits
/// until the file and its name have reached the disk (some milliseconds, and more on a busy one).
enum class Durability { program, machine };

/// A file that appears, complete, when it is committed, and not at all otherwise.
///
/// What is written to `stream()` goes to a temporary file in the same folder; `commit` renames it to `path`, so that a
/// reader sees the old content or the new one, never a part. Without a commit the destructor removes the temporary and
/// leaves `path` as it was. Where `path` is a symbolic link, the file it leads to is replaced; where it is a device or
/// a pipe, the bytes go straight to it.
///
///     AtomicFile file("frame.csv");
///     file.stream() << "a,b\n";
///     file.commit();
///
/// That holds against full disks and killed programs; with Durability::machine against power cuts, too. What a program
/// that was killed leaves of a temporary, `remove_stale_temporaries` removes.
class AtomicFile {
 public:
  /// Throws FileError when the temporary cannot be created, or `path` is a folder or write-protected.
  explicit AtomicFile(const std::filesystem::path& path, Durability durability = Durability::program);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// Binary, in the "C" locale. After a failed write it is in the state bad(); `commit` reports the reason.
  std::ostream& stream() { return stream_; }
  /// Writes what is buffered, closes the file and gives it its name. Throws DiskError (disk full, file-size limit, ...)
  /// or FileError with the path and the system's reason when that or any write before failed; the temporary is then
  /// removed.
  /// Signals of the system that would end the program for such an error (SIGXFSZ, SIGPIPE) are held back.
  void commit();

 private:
  class Buffer;

  std::filesystem::path path_;       // as given
  std::filesystem::path target_;     // links followed
  std::filesystem::path temporary_;  // empty when there is none
  Durability durability_;
  std::unique_ptr<Buffer> buffer_;
  std::ostream stream_;
};

}  // namespace base
