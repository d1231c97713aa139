#include "FoamSim/sweep/grid.h"
#include "tests/fuzz/memory_file.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::read_file({data, size}, [](const auto& file) {
    foamsim::sweep::count_runs(foamsim::sweep::read_grid(file.string(), foamsim::built_in_catalogue()));
  });
  return 0;
}
