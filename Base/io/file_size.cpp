#include "Base/io/file_size.h"

#include "Base/error.h"
#include "Base/machine/memory.h"

namespace base {

void require_text_file(const std::filesystem::path& file, const std::string& what) {
  std::error_code failed;
  if (!std::filesystem::is_regular_file(file, failed))
    throw FileError(file.string() + ": there is no such " + what + ", or it cannot be read");
  const std::uintmax_t size = std::filesystem::file_size(file, failed);
  if (failed || size <= longest_text_file) return;
  throw InputError(file.string() + ": it has " + bytes_in_words(static_cast<double>(size)) + "; no " + what +
                   " is longer than " + bytes_in_words(static_cast<double>(longest_text_file)));
}

}  // namespace base
