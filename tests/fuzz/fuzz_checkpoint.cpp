// The content of a checkpoint: its checksum is always right.
#include <nlohmann/json.hpp>

#include "Base/error.h"
#include "FoamSim/run/scene_motion.h"
#include "LosTopos/run/sealed_bytes.h"
#include "tests/fuzz/memory_file.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    lostopos::run::take_checkpoint(lostopos::run::sealed({data, size}), "checkpoint", foamsim::checkpoint_format(),
                                   [](const nlohmann::json& content) {
                                     foamsim::resume(foamsim::checkpoint_from(content, foamsim::built_in_catalogue()));
                                   });
  } catch (const base::InputError&) {  // NOLINT(bugprone-empty-catch): that is what it may say
  }
  return 0;
}
