#include "Base/io/atomic_file.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <ctime>
#include <locale>
#include <streambuf>
#include <string>
#include <system_error>
#include <vector>

#include "Base/error.h"
#include "Base/io/disk.h"
#include "Base/io/temporary_file.h"
#include "Base/io/write_error.h"

namespace base {
namespace {

namespace fs = std::filesystem;

std::string cannot_write(const fs::path& path) {
  return "cannot write '" + path.string() + "'";
}

// Makes the file-size limit and a closed pipe errors of write(2), in this thread, instead of signals that end the
// program. A signal that was waiting before is not ours and is left waiting.
class SignalsHeldBack {
 public:
  SignalsHeldBack() {
    sigset_t waiting;
    sigemptyset(&ours_);
    sigpending(&waiting);
    for (const int signal : {SIGXFSZ, SIGPIPE})
      if (sigismember(&waiting, signal) == 0) sigaddset(&ours_, signal);
    pthread_sigmask(SIG_BLOCK, &ours_, &mask_before_);
  }
  ~SignalsHeldBack() {
    const int error = errno;
    const timespec no_wait{};
    for (int i = 0; i < 2; ++i) sigtimedwait(&ours_, nullptr, &no_wait);
    pthread_sigmask(SIG_SETMASK, &mask_before_, nullptr);
    errno = error;
  }
  SignalsHeldBack(const SignalsHeldBack&) = delete;
  SignalsHeldBack& operator=(const SignalsHeldBack&) = delete;

 private:
  sigset_t ours_{}, mask_before_{};
};

fs::path follow_links(fs::path path) {
  constexpr int most_links = 40;  // as the Linux kernel
  std::error_code ignored;
  for (int i = 0; i < most_links && fs::is_symlink(path, ignored); ++i) {
    const fs::path leads_to = fs::read_symlink(path, ignored);
    path = leads_to.is_absolute() ? leads_to : path.parent_path() / leads_to;
  }
  return path;
}

}  // namespace

class AtomicFile::Buffer final : public std::streambuf {
 public:
  explicit Buffer(int descriptor) : descriptor_(descriptor), bytes_(std::size_t{1} << 16U) { empty(); }
  ~Buffer() override { close(); }
  Buffer(const Buffer&) = delete;
  Buffer& operator=(const Buffer&) = delete;

  // The system's number of the first failure, 0 for none.
  int error() const { return error_; }
  int descriptor() const { return descriptor_; }
  void close() {
    if (descriptor_ >= 0 && ::close(descriptor_) != 0 && error_ == 0) error_ = errno;
    descriptor_ = -1;
  }

 protected:
  int_type overflow(int_type c) override {
    if (!write_out()) return traits_type::eof();
    if (!traits_type::eq_int_type(c, traits_type::eof())) {
      *pptr() = traits_type::to_char_type(c);
      pbump(1);
    }
    return traits_type::not_eof(c);
  }
  int sync() override { return write_out() ? 0 : -1; }

 private:
  void empty() { setp(bytes_.data(), bytes_.data() + bytes_.size()); }

  bool write_out() {
    const SignalsHeldBack held_back;
    const char* next = pbase();
    while (next < pptr() && error_ == 0) {  // ends: every turn writes at least a byte, or fails
      const ssize_t written = ::write(descriptor_, next, static_cast<std::size_t>(pptr() - next));
      if (written >= 0) {
        next += written;
      } else if (errno != EINTR) {
        error_ = errno;
      }
    }
    empty();
    return error_ == 0;
  }

  int descriptor_;
  int error_ = 0;
  std::vector<char> bytes_;
};

AtomicFile::AtomicFile(const fs::path& path, Durability durability)
    : path_(path), target_(follow_links(path)), durability_(durability), stream_(nullptr) {
  struct stat status {};
  const bool exists = ::stat(target_.c_str(), &status) == 0;
  if (path.filename().empty() || (exists && S_ISDIR(status.st_mode)))
    throw FileError(cannot_write(path) + ": it is a folder; name a file in it");
  int descriptor = -1;
  if (exists && !S_ISREG(status.st_mode)) {
    descriptor = ::open(target_.c_str(), O_WRONLY | O_CLOEXEC);
  } else {
    if (exists && ::access(target_.c_str(), W_OK) != 0) throw_write_error(cannot_write(path), errno);
    constexpr int most_trials = 1000;
    for (int trial = 0; trial < most_trials && descriptor < 0; ++trial) {
      temporary_ = temporary_name(target_, trial);
      descriptor = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
      if (descriptor < 0 && errno != EEXIST) break;
    }
  }
  if (descriptor < 0) throw_write_error(cannot_write(path), errno);
  // A file that is replaced keeps its permissions; failing in that is no reason to lose the data.
  if (exists && !temporary_.empty() && ::fchmod(descriptor, status.st_mode & 07777U) != 0) errno = 0;
  buffer_ = std::make_unique<Buffer>(descriptor);
  stream_.rdbuf(buffer_.get());
  stream_.imbue(std::locale::classic());
}

AtomicFile::~AtomicFile() {
  buffer_.reset();
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void AtomicFile::commit() {
  if (!buffer_) return;
  stream_.exceptions(std::ios::goodbit);  // the reason is thrown below, whatever the caller asked of the stream
  stream_.flush();
  const bool durable = durability_ == Durability::machine && !temporary_.empty();
  if (durable && buffer_->error() == 0) wait_for_disk(buffer_->descriptor(), path_);
  buffer_->close();
  int error = buffer_->error();
  const bool stream_failed = stream_.fail();
  stream_.rdbuf(nullptr);
  buffer_.reset();
  if (error == 0 && stream_failed) throw FileError(cannot_write(path_) + ": writing to its stream failed");
  if (error == 0 && !temporary_.empty()) {
    if (::rename(temporary_.c_str(), target_.c_str()) == 0) {
      temporary_.clear();
    } else {
      error = errno;
    }
  }
  if (error != 0) throw_write_error(cannot_write(path_), error);
  if (durable) wait_for_disk(target_.parent_path().empty() ? "." : target_.parent_path());
}

}  // namespace base
