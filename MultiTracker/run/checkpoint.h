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
  return {"multitracker", 2};
}

nlohmann::json checkpoint_content(const Checkpoint& checkpoint);

/// Throws base::Error for anything but what checkpoint_content gives: options are checked as if they were given, the
/// surfaces as SurfaceMesh::from_state does.
Checkpoint checkpoint_from(const nlohmann::json& content);

}  // namespace multitracker
