#include "FoamSim/scenes/reference_options.h"
#include "FoamSim/scenes/scene.h"
#include "tests/fuzz/memory_file.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::read_file({data, size}, [](const auto& file) {
    foamsim::validate(foamsim::read_reference_options(file.string(), foamsim::built_in_catalogue()));
  });
  return 0;
}
