#include "FoamSim/scenes/scene_registry.h"

#include "FoamSim/scenes/scene_families.h"

namespace foamsim {
namespace {

std::vector<SceneEntry> all_scenes() {
  std::vector<SceneEntry> all;
  for (auto* family : {closed_scenes, junction_scenes, wire_scenes, foam_scenes})
    for (SceneEntry& scene : family()) all.push_back(std::move(scene));
  return all;
}

}  // namespace

const base::Registry<SceneEntry>& built_in_scenes() {
  static const base::Registry<SceneEntry> scenes("scene", all_scenes());
  return scenes;
}

}  // namespace foamsim
