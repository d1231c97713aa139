#pragma once

#include <memory>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "Base/options/option_set.h"
#include "LosTopos/mesh/box_walls.h"
#include "LosTopos/surface_tracker.h"
#include "MultiTracker/flows/surface_flow.h"
#include "MultiTracker/scenes/step_lengths.h"

namespace multitracker {

/// How a surface is moved: by what, and how far in a step.
struct Drive {
  std::unique_ptr<SurfaceFlow> flow;
  StepLengths dt;
};

/// What of a scene's box its surface is bound to, and how: a vertex on a wall slides along it, or does not move at all.
enum class AtWalls { free, slide, stay };

/// A surface and the flow that moves it.
struct SceneEntry {
  using Default = std::pair<std::string_view, base::OptionValue>;

  std::string_view name;
  std::string_view summary;
  std::vector<base::OptionSpec> options;  ///< its own, in addition to those of every scene
  std::vector<Default> defaults;          ///< where they differ from those of every scene
  lostopos::SurfaceMesh (*surface)(const base::OptionSet&);
  /// For the surface at the start, which may come from a file.
  Drive (*drive)(const base::OptionSet&, const lostopos::SurfaceMesh& start);
  /// Says what is held at the start, besides what is at walls; null: nothing.
  void (*hold)(const base::OptionSet&, lostopos::SurfaceTracker&) = nullptr;
  bool closed = true;  ///< false: films end at rings, and so have no volumes to keep
  AtWalls at_walls = AtWalls::free;
  lostopos::Vec3 box = lostopos::Vec3::Ones();  ///< from the origin, of the scene's own surface; a file's: the unit box
  /// About how many triangles its own surface has.
  double (*triangles)(const base::OptionSet&) = nullptr;
};

/// The scene's own surface. Throws base::InputError for options out of range, and, before memory is taken, where it
/// takes more than the option memory_limit.
lostopos::SurfaceMesh own_surface(const SceneEntry& scene, const base::OptionSet& options);

const std::vector<SceneEntry>& scene_entries();
/// Throws base::InputError with the nearest name.
const SceneEntry& scene_by_name(std::string_view name);

/// All options of a scene with their defaults.
base::OptionSet options_of(const SceneEntry& scene);
/// The options that every scene has, with the defaults for plain tracking (docs/method.md "Remeshing").
std::vector<base::OptionSpec> common_option_specs();

/// The walls that a scene's surface is bound to, of one that is its own or comes from a file. In a scene whose walls
/// hold what is at them, only a surface that ends there has walls.
std::optional<lostopos::BoxWalls> walls_of(const SceneEntry& scene, const lostopos::SurfaceMesh& surface,
                                           bool from_file);

/// For a surface that ends at walls, after a step: a vertex that has come to a wall is moved onto it where nothing is
/// in the way and held there from then on, and triangles that lie in a wall are removed. Throws what
/// SurfaceTracker::advance throws.
void keep_to_walls(const SceneEntry& scene, const lostopos::BoxWalls& walls, lostopos::SurfaceTracker& tracker);

/// The tracker of a scene at its start, on `surface`, held at the walls: its resolution is that of the options or, when
/// that is 0, the mean edge length. Vertices at or beyond a wall are put on it, and triangles in the walls of a surface
/// that ends there are removed. `interruption`: see TrackerOptions. Throws base::InputError for options out of range,
/// and where the surface takes more than the option memory_limit at that resolution.
lostopos::SurfaceTracker start_tracker(const SceneEntry& scene, const base::OptionSet& options,
                                       lostopos::SurfaceMesh surface, const std::optional<lostopos::BoxWalls>& walls,
                                       const base::Interruption& interruption = {});
/// The same on a surface of the scene's own.
lostopos::SurfaceTracker start_tracker(const SceneEntry& scene, const base::OptionSet& options,
                                       lostopos::SurfaceMesh surface);

}  // namespace multitracker
