#include "tests/fuzz/memory_file.h"

#include <sys/mman.h>
#include <unistd.h>

#include <cstdlib>

#include "Base/error.h"

namespace fuzz {

MemoryFile::MemoryFile(std::span<const std::uint8_t> bytes) : descriptor_(memfd_create("fuzz", 0)) {
  if (descriptor_ < 0) std::abort();
  while (!bytes.empty()) {
    const auto written = write(descriptor_, bytes.data(), bytes.size());
    if (written <= 0) std::abort();
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
}

MemoryFile::~MemoryFile() {
  close(descriptor_);
}

std::filesystem::path MemoryFile::path() const {
  return "/proc/self/fd/" + std::to_string(descriptor_);
}

bool read_file(std::span<const std::uint8_t> bytes, const std::function<void(const std::filesystem::path&)>& read) {
  const MemoryFile file(bytes);
  try {
    read(file.path());
    return true;
  } catch (const base::InputError&) {
    return false;
  }
}

}  // namespace fuzz
