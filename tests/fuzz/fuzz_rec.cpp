#include "LosTopos/io/rec.h"
#include "tests/fuzz/memory_file.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::read_file({data, size}, [](const auto& file) { lostopos::to_mesh(lostopos::read_rec(file)); });
  return 0;
}
