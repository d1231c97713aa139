// The content of a checkpoint of the tracker: its checksum is always right.
#include <nlohmann/json.hpp>

#include "Base/error.h"
#include "LosTopos/run/sealed_bytes.h"
#include "MultiTracker/run/tracking.h"
#include "tests/fuzz/memory_file.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    lostopos::run::take_checkpoint(
        lostopos::run::sealed({data, size}), "checkpoint", multitracker::checkpoint_format(),
        [](const nlohmann::json& content) { multitracker::Tracking(multitracker::checkpoint_from(content)); });
  } catch (const base::InputError&) {  // NOLINT(bugprone-empty-catch): that is what it may say
  }
  return 0;
}
