// The program of one harness, FUZZ_HARNESS: what libFuzzer calls.
#include <cstddef>

#include "tests/fuzz/harnesses.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::FUZZ_HARNESS({data, size});
  return 0;
}
