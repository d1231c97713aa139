#pragma once

#include <string_view>
#include <vector>

#include "Base/options/option_set.h"
#include "FoamSim/dynamics/simulation.h"
#include "LosTopos/mesh/surface_mesh.h"

namespace foamsim {

/// A built-in scene: how its start surface is made, and which of its options' defaults differ from the general ones.
struct SceneEntry {
  std::string_view name;
  std::string_view summary;
  std::vector<std::pair<std::string_view, base::OptionValue>> defaults;
  std::string_view uses;  ///< what n (and other shape options) mean here
  lostopos::SurfaceMesh (*build)(const base::OptionSet&);
  /// Gives the films their circulation at the start; null: at rest.
  void (*set_motion)(const base::OptionSet&, Simulation&) = nullptr;
};

/// All built-in scenes. A new one is a shape and an entry in the table.
const std::vector<SceneEntry>& scene_entries();

/// Throws base::InputError with the nearest name.
const SceneEntry& scene_by_name(std::string_view name);

}  // namespace foamsim
