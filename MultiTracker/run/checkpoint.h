#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "LosTopos/run/checkpoint.h"
#include "MultiTracker/run/metrics.h"
#include "MultiTracker/scenes/scene.h"

namespace multitracker {

/// Which scene is tracked, with what options, and on what surface.
struct Origin {
  const SceneEntry* scene;  ///< not null
  base::OptionSet options;
  std::string mesh_file = {};                              ///< empty: the scene's own surface
  std::optional<lostopos::SurfaceMesh::State> given = {};  ///< the file's surface, which the flow may depend on
};

/// What tracking needs to go on as if it had not stopped, to the bit.
struct Checkpoint {
  Origin origin;
  lostopos::SurfaceTracker::State surface;
  long step = 0;
  Metrics start;
  std::vector<lostopos::RegionVolume> start_volumes;
};

inline lostopos::run::CheckpointFormat checkpoint_format() {
  return {"multitracker", 1};
}

nlohmann::json checkpoint_content(const Checkpoint& checkpoint);

/// `file`: a checkpoint, or the folder of a run. Throws base::FileError when it cannot be read, and base::InputError,
/// naming the file, for anything that is not a whole checkpoint of a known version.
Checkpoint read_checkpoint(const std::filesystem::path& file);

}  // namespace multitracker
