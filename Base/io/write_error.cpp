#include "Base/io/write_error.h"

#include <cerrno>
#include <system_error>

#include "Base/error.h"

namespace base {
namespace {

bool is_of_the_disk(int error) {
  return error == ENOSPC || error == EDQUOT || error == EFBIG || error == EIO;
}

}  // namespace

void throw_write_error(const std::string& what, int error, const std::string& advice) {
  const std::string reason = error == 0 ? "the disk may be full" : std::generic_category().message(error);
  if (error == 0 || is_of_the_disk(error)) throw DiskError(what + ": " + reason);
  throw FileError(what + ": " + reason + (advice.empty() ? "" : "; ") + advice);
}

void make_folder(const std::filesystem::path& folder, const std::string& advice) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw_write_error("cannot make the folder " + folder.string(), error.value(), advice);
}

}  // namespace base
