#include "LosTopos/io/byte_reader.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

#include "Base/error.h"
#include "LosTopos/io/read_error.h"

namespace lostopos {
namespace {

constexpr std::size_t window_bytes = std::size_t{1} << 18U;

[[noreturn]] void throw_unreadable(const std::string& name, const std::string& reason) {
  throw base::FileError("cannot read '" + name + "': " + reason);
}

}  // namespace

ByteReader::ByteReader(const std::filesystem::path& path) : name_(path.string()) {
  struct stat status {};
  // Looked at before it is opened: opening a pipe would wait for a writer.
  if (::stat(path.c_str(), &status) != 0) throw_unreadable(name_, std::generic_category().message(errno));
  if (S_ISDIR(status.st_mode)) throw_unreadable(name_, "it is a folder; name a file in it");
  if (!S_ISREG(status.st_mode)) throw_unreadable(name_, "it is not a regular file; save its content to one first");
  descriptor_ = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor_ < 0) throw_unreadable(name_, std::generic_category().message(errno));
  size_ = static_cast<std::uint64_t>(status.st_size);
}

ByteReader::~ByteReader() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void ByteReader::seek(std::uint64_t offset) {
  if (offset > size_)
    fail("byte " + std::to_string(offset) + " is wanted, but the file ends at " + std::to_string(size_));
  if (offset >= window_start_ && offset - window_start_ <= window_.size()) {
    next_ = static_cast<std::size_t>(offset - window_start_);
    return;
  }
  window_.clear();
  window_start_ = offset;
  next_ = 0;
}

void ByteReader::skip(std::uint64_t bytes) {
  require_records(bytes, 1, "bytes");
  seek(position() + bytes);
}

std::string ByteReader::read_line(std::size_t longest) {
  std::string line;
  for (std::size_t i = 0; i <= longest && remaining() > 0; ++i) {
    const char c = read<char>();
    if (c == '\n') {
      if (!line.empty() && line.back() == '\r') line.pop_back();
      return line;
    }
    line += c;
  }
  fail(remaining() == 0 ? "the file ends in the middle of a line"
                        : "no end of line within " + std::to_string(longest) + " bytes");
}

std::string ByteReader::read_text() {
  std::string text;
  while (remaining() > 0) {
    if (next_ == window_.size()) fill(1);
    const std::string_view piece(window_.data() + next_, window_.size() - next_);
    if (const std::size_t zero = piece.find('\0'); zero != std::string_view::npos) {
      skip(zero);
      fail("a zero byte, which no text file holds; is this a binary file under another name?");
    }
    text += piece;
    next_ = window_.size();
  }
  return text;
}

void ByteReader::require_records(std::uint64_t count, std::uint64_t bytes_each, std::string_view what) const {
  if (bytes_each == 0 || count <= remaining() / bytes_each) return;
  const std::string each = bytes_each == 1 ? "" : " of at least " + std::to_string(bytes_each) + " bytes each";
  fail(std::to_string(count) + " " + std::string(what) + each + " should follow, but the file ends after " +
       std::to_string(remaining()) + " bytes; it is cut short or its counts are wrong");
}

void ByteReader::fail(const std::string& problem) const {
  throw_at_byte(name_, position(), problem);
}

void ByteReader::fill(std::size_t at_least) {
  require_records(at_least, 1, "bytes");
  const std::uint64_t start = position();
  window_.resize(static_cast<std::size_t>(std::min<std::uint64_t>(window_bytes, size_ - start)));
  window_start_ = start;
  next_ = 0;
  window_.resize(read_at(start, window_.data(), window_.size()));
  if (window_.size() < at_least) fail("the file became shorter while it was read");
}

std::size_t ByteReader::read_at(std::uint64_t offset, char* target, std::size_t bytes) {
  std::size_t done = 0;
  while (done < bytes) {  // ends: every turn reads at least a byte, or leaves
    const ssize_t got = ::pread(descriptor_, target + done, bytes - done, static_cast<off_t>(offset + done));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) throw_unreadable(name_, std::generic_category().message(errno));
    if (got == 0) break;
    done += static_cast<std::size_t>(got);
  }
  return done;
}

}  // namespace lostopos
