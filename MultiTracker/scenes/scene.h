#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "LosTopos/mesh/surface_mesh.h"
#include "MultiTracker/flows/flow.h"

namespace multitracker {

/// A surface and the flow that moves it.
struct SceneEntry {
  std::string_view name;
  std::string_view summary;
  lostopos::SurfaceMesh (*surface)(long subdivisions);
  std::unique_ptr<Flow> (*flow)();
};

const std::vector<SceneEntry>& scene_entries();
/// Throws lostopos::InputError that names the scenes there are.
const SceneEntry& scene_by_name(std::string_view name);

}  // namespace multitracker
