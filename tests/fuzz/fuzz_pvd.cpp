#include "LosTopos/io/pvd.h"
#include "tests/fuzz/memory_file.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::read_file({data, size}, [](const auto& file) { lostopos::read_pvd(file); });
  return 0;
}
