#pragma once

#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "Base/options/option_set.h"
#include "LosTopos/surface_tracker.h"
#include "MultiTracker/flows/surface_flow.h"

namespace multitracker {

/// How a surface is moved: by what, and how far in a step.
struct Drive {
  std::unique_ptr<SurfaceFlow> flow;
  double dt;  ///< T, > 0
};

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
  /// Says what is held at the start; null: nothing.
  void (*hold)(const base::OptionSet&, lostopos::SurfaceTracker&) = nullptr;
  bool closed = true;  ///< false: films end at rings, and so have no volumes to keep
};

const std::vector<SceneEntry>& scene_entries();
/// Throws base::InputError with the nearest name.
const SceneEntry& scene_by_name(std::string_view name);

/// All options of a scene with their defaults.
base::OptionSet options_of(const SceneEntry& scene);
/// The options that every scene has, with the defaults for plain tracking (docs/method.md "Remeshing").
std::vector<base::OptionSpec> common_option_specs();

/// The tracker of a scene at its start, on `surface`: its resolution is that of the options or, when that is 0, the
/// mean edge length. Throws base::InputError for options out of range.
lostopos::SurfaceTracker start_tracker(const SceneEntry& scene, const base::OptionSet& options,
                                       lostopos::SurfaceMesh surface);

}  // namespace multitracker
