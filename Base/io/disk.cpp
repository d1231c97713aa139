#include "Base/io/disk.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>

#include "Base/io/write_error.h"

namespace base {

void wait_for_disk(int descriptor, const std::filesystem::path& path) {
  // Devices, pipes and file systems without a disk refuse with EINVAL and the like.
  if (::fsync(descriptor) != 0 && (errno == EIO || errno == ENOSPC || errno == EDQUOT))
    throw_write_error("cannot write '" + path.string() + "'", errno);
}

void wait_for_disk(const std::filesystem::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return;
  try {
    wait_for_disk(descriptor, path);
  } catch (...) {
    ::close(descriptor);
    throw;
  }
  ::close(descriptor);
}

}  // namespace base
