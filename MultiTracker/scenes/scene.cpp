#include "MultiTracker/scenes/scene.h"

#include "Base/names/nearest_name.h"
#include "LosTopos/mesh/measures.h"
#include "LosTopos/tracker_options.h"
#include "MultiTracker/scenes/scene_lists.h"

namespace multitracker {

const std::vector<SceneEntry>& scene_entries() {
  static const std::vector<SceneEntry> entries = [] {
    std::vector<SceneEntry> all = prescribed_scenes();
    for (auto more : {growth_scenes(), film_scenes()})
      for (SceneEntry& entry : more) all.push_back(std::move(entry));
    return all;
  }();
  return entries;
}

const SceneEntry& scene_by_name(std::string_view name) {
  return base::find_by_name(scene_entries(), name, "scene");
}

std::vector<base::OptionSpec> common_option_specs() {
  std::vector<base::OptionSpec> specs{
      base::non_negative_number("resolution", 0, "target mean edge length; 0: that of the start surface"),
      base::whole_number("steps", 100, 0, "number of steps"),
      base::whole_number("frame_every", 10, 0, "steps from one frame to the next; 0: only the first and the last"),
      base::whole_number("checkpoint_every", 500, 0, "steps between checkpoints; 0: at the end only"),
      base::whole_number("seed", 1, 0, "seed of everything random"),
  };
  lostopos::TrackerOptions plain;
  plain.remesh.max_volume_change = 1e-4;
  plain.topology.enabled = true;
  plain.topology.merge_distance = 0.02;
  plain.topology.separation = lostopos::SeparationRule::flow;
  for (base::OptionSpec& spec : lostopos::tracker_option_specs(plain)) specs.push_back(std::move(spec));
  return specs;
}

base::OptionSet options_of(const SceneEntry& scene) {
  std::vector<base::OptionSpec> specs = common_option_specs();
  specs.insert(specs.begin(), scene.options.begin(), scene.options.end());
  base::OptionSet options(std::move(specs), "multitracker scenes " + std::string(scene.name));
  for (const auto& [key, value] : scene.defaults) options.set_default(key, value);
  return options;
}

lostopos::SurfaceTracker start_tracker(const SceneEntry& scene, const base::OptionSet& options,
                                       lostopos::SurfaceMesh surface) {
  lostopos::TrackerOptions tracker_options = lostopos::tracker_options(options);
  const double resolution = options.number("resolution");
  tracker_options.resolution = resolution > 0 ? resolution : lostopos::mean_edge_length(surface);
  lostopos::SurfaceTracker tracker(std::move(surface), tracker_options);
  if (scene.hold != nullptr) scene.hold(options, tracker);
  return tracker;
}

}  // namespace multitracker
