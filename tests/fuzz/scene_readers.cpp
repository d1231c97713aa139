#include <nlohmann/json.hpp>

#include "Base/error.h"
#include "FoamSim/run/scene_motion.h"
#include "FoamSim/scenes/reference_options.h"
#include "FoamSim/scenes/scene.h"
#include "FoamSim/scenes/toml_scene.h"
#include "FoamSim/sweep/grid.h"
#include "LosTopos/run/sealed_bytes.h"
#include "MultiTracker/run/tracking.h"
#include "MultiTracker/scenes/reference_options.h"
#include "tests/fuzz/harnesses.h"
#include "tests/fuzz/memory_file.h"

namespace fuzz {
namespace {

bool feed_content(std::span<const std::uint8_t> bytes, const lostopos::run::CheckpointFormat& format,
                  const lostopos::run::TakeCheckpoint& take) {
  try {
    lostopos::run::take_checkpoint(lostopos::run::sealed(bytes), "checkpoint", format, take);
    return true;
  } catch (const base::InputError&) {
    return false;
  }
}

}  // namespace

bool feed_toml(std::span<const std::uint8_t> bytes) {
  return read_file(bytes, [](const auto& file) {
    foamsim::validate(foamsim::read_toml_scene(file.string(), foamsim::built_in_catalogue()));
  });
}

bool feed_grid(std::span<const std::uint8_t> bytes) {
  return read_file(bytes, [](const auto& file) {
    foamsim::sweep::count_runs(foamsim::sweep::read_grid(file.string(), foamsim::built_in_catalogue()));
  });
}

bool feed_options(std::span<const std::uint8_t> bytes) {
  return read_file(bytes, [](const auto& file) {
    foamsim::validate(foamsim::read_reference_options(file.string(), foamsim::built_in_catalogue()));
  });
}

bool feed_tracker_options(std::span<const std::uint8_t> bytes) {
  return read_file(bytes, [](const auto& file) { multitracker::read_reference_options(file.string()); });
}

bool feed_checkpoint(std::span<const std::uint8_t> bytes) {
  return feed_content(bytes, foamsim::checkpoint_format(), [](const nlohmann::json& content) {
    foamsim::resume(foamsim::checkpoint_from(content, foamsim::built_in_catalogue()));
  });
}

bool feed_tracker_checkpoint(std::span<const std::uint8_t> bytes) {
  return feed_content(bytes, multitracker::checkpoint_format(), [](const nlohmann::json& content) {
    multitracker::Tracking(multitracker::checkpoint_from(content));
  });
}

}  // namespace fuzz
