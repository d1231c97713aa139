#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "LosTopos/io/byte_order.h"

namespace lostopos {

/// Buffered, bounds-checked reading of one regular file. What the file itself does wrong is an InputError that names
/// the file and the byte; what the system refuses (missing, a folder, not permitted) is a FileError.
///
/// Memory: a window of at most 256 KiB, however large the file. A count found in a file is checked by
/// `require_records` before anything is reserved for it.
class ByteReader {
 public:
  explicit ByteReader(const std::filesystem::path& path);
  ~ByteReader();
  ByteReader(const ByteReader&) = delete;
  ByteReader& operator=(const ByteReader&) = delete;

  /// The path as given, for messages.
  const std::string& name() const { return name_; }
  std::uint64_t size() const { return size_; }
  std::uint64_t position() const { return window_start_ + next_; }
  std::uint64_t remaining() const { return size_ - position(); }

  /// Throws InputError when `offset` lies beyond the end.
  void seek(std::uint64_t offset);
  /// Throws InputError when fewer than `bytes` remain.
  void skip(std::uint64_t bytes);
  /// The next sizeof(T) bytes as a number. Throws InputError at the end of the file.
  template <class T>
  T read(std::endian order = std::endian::little) {
    if (window_.size() - next_ < sizeof(T)) fill(sizeof(T));
    const T value = number_from_bytes<T>(window_.data() + next_, order);
    next_ += sizeof(T);
    return value;
  }
  /// The bytes up to the next newline, which is consumed; a carriage return before it is dropped. Throws InputError
  /// when there is none within `longest` bytes.
  std::string read_line(std::size_t longest);
  /// All that remains, as text. Throws InputError at the first zero byte: no text holds one, but binary data and files
  /// with holes do, which are not worth holding in memory.
  std::string read_text();

  /// Throws InputError, at the present position, unless `count` records of at least `bytes_each` bytes fit into the
  /// rest of the file. `what` names the records in the plural.
  void require_records(std::uint64_t count, std::uint64_t bytes_each, std::string_view what) const;
  [[noreturn]] void fail(const std::string& problem) const;

 private:
  void fill(std::size_t at_least);
  std::size_t read_at(std::uint64_t offset, char* target, std::size_t bytes);

  std::string name_;
  int descriptor_ = -1;
  std::uint64_t size_ = 0;
  std::vector<char> window_;  // bytes [window_start_, window_start_ + window_.size()) of the file
  std::uint64_t window_start_ = 0;
  std::size_t next_ = 0;  // place in the window of the next byte
};

}  // namespace lostopos
