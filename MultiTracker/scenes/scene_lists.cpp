#include "MultiTracker/scenes/scene_lists.h"

namespace multitracker {

base::OptionSpec subdivisions(long count) {
  return {"subdivisions", count, "of each triangle of the start surface into four", "0 to 8",
          [](const base::OptionValue& value) { return std::get<long>(value) >= 0 && std::get<long>(value) <= 8; }};
}

}  // namespace multitracker
