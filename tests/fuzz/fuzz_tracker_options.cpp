#include "MultiTracker/scenes/reference_options.h"
#include "tests/fuzz/memory_file.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::read_file({data, size}, [](const auto& file) { multitracker::read_reference_options(file.string()); });
  return 0;
}
