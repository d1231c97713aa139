#include "MultiTracker/scenes/scene.h"

#include <algorithm>

#include "Base/names/nearest_name.h"
#include "LosTopos/memory_limit.h"
#include "LosTopos/mesh/measures.h"
#include "LosTopos/tracker_options.h"
#include "MultiTracker/scenes/scene_lists.h"

namespace multitracker {
namespace {

void hold_at_walls(const SceneEntry& scene, const lostopos::BoxWalls& walls, lostopos::SurfaceTracker& tracker) {
  lostopos::hold_in_box_walls(tracker.mesh(), tracker.held(), walls.low, walls.high);
  if (scene.at_walls != AtWalls::stay) return;
  for (lostopos::Vertex v : tracker.mesh().vertices())
    if (tracker.held()[v] != lostopos::Hold::none) tracker.held()[v] = lostopos::Hold::all;
}

void require_memory_for(double triangles, const base::OptionSet& options) {
  lostopos::require_memory({triangles, lostopos::default_bytes_of_triangle * triangles},
                           lostopos::memory_limit(options));
}

}  // namespace

lostopos::SurfaceMesh own_surface(const SceneEntry& scene, const base::OptionSet& options) {
  if (scene.triangles != nullptr) require_memory_for(scene.triangles(options), options);
  return scene.surface(options);
}

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
      base::whole_number("rec_every", 0, 0, "steps between meshes as the reference writes them, .rec; 0: none"),
      base::whole_number("obj_every", 0, 0, "steps between .obj meshes with normals; 0: none"),
      base::whole_number("checkpoint_every", 0, 0, "steps between checkpoints; 0: by checkpoint_seconds alone"),
      base::non_negative_number("checkpoint_seconds", 30,
                                "wall time between checkpoints, s, longer where they would take over 1% of it; 0: by "
                                "checkpoint_every and at the end only"),
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

std::optional<lostopos::BoxWalls> walls_of(const SceneEntry& scene, const lostopos::SurfaceMesh& surface,
                                           bool from_file) {
  if (scene.at_walls == AtWalls::free) return std::nullopt;
  const lostopos::BoxWalls walls{lostopos::Vec3::Zero(), from_file ? lostopos::Vec3::Ones() : scene.box};
  if (scene.at_walls == AtWalls::stay && !lostopos::ends_at_walls(surface, walls)) return std::nullopt;
  return walls;
}

void keep_to_walls(const SceneEntry& scene, const lostopos::BoxWalls& walls, lostopos::SurfaceTracker& tracker) {
  const lostopos::SurfaceMesh& mesh = tracker.mesh();
  std::vector<lostopos::Vec3> there(mesh.positions().begin(), mesh.positions().end());
  for (lostopos::Vertex v : mesh.vertices()) there[v.index()] = lostopos::put_on_walls(walls, mesh.position(v));
  if (!std::ranges::equal(there, mesh.positions())) tracker.advance(there);
  hold_at_walls(scene, walls, tracker);
  lostopos::remove_triangles_in_walls(tracker.mesh(), walls);
}

lostopos::SurfaceTracker start_tracker(const SceneEntry& scene, const base::OptionSet& options,
                                       lostopos::SurfaceMesh surface, const std::optional<lostopos::BoxWalls>& walls,
                                       const base::Interruption& interruption) {
  if (walls) {
    for (lostopos::Vertex v : surface.vertices())
      surface.set_position(v, lostopos::put_on_walls(*walls, surface.position(v)));
    if (lostopos::ends_at_walls(surface, *walls)) lostopos::remove_triangles_in_walls(surface, *walls);
  }
  lostopos::TrackerOptions tracker_options = lostopos::tracker_options(options);
  const double resolution = options.number("resolution");
  tracker_options.resolution = resolution > 0 ? resolution : lostopos::mean_edge_length(surface);
  tracker_options.interruption = interruption;
  if (tracker_options.remeshing)
    require_memory_for(lostopos::triangles_on(lostopos::total_area(surface), tracker_options.resolution), options);
  lostopos::SurfaceTracker tracker(std::move(surface), tracker_options);
  if (walls)
    hold_at_walls(scene, *walls, tracker);
  else if (scene.hold != nullptr)
    scene.hold(options, tracker);
  return tracker;
}

lostopos::SurfaceTracker start_tracker(const SceneEntry& scene, const base::OptionSet& options,
                                       lostopos::SurfaceMesh surface) {
  const auto walls = walls_of(scene, surface, false);
  return start_tracker(scene, options, std::move(surface), walls);
}

}  // namespace multitracker
