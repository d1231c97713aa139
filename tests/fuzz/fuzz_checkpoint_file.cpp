#include <nlohmann/json.hpp>

#include "LosTopos/run/checkpoint.h"
#include "tests/fuzz/memory_file.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::read_file({data, size}, [](const auto& file) {
    lostopos::run::read_checkpoint(file, {"foamsim", 5}, [](const nlohmann::json&) {});
  });
  return 0;
}
