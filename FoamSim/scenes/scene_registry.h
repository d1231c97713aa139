#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "Base/options/option_set.h"
#include "Base/registry/registry.h"
#include "FoamSim/dynamics/simulation.h"
#include "LosTopos/mesh/surface_mesh.h"

namespace foamsim {

/// A start surface that users know by name: how it is made, its own options, and which defaults of the general ones it
/// changes.
struct SceneEntry {
  std::string name;
  std::string summary;
  std::vector<base::OptionSpec> options;  ///< its own; their owner is set by the registry
  std::vector<std::pair<std::string, base::OptionValue>> defaults;
  /// What it holds is marked in the mesh, by shapes/held.h.
  std::function<lostopos::SurfaceMesh(const base::OptionSet&)> build;
  /// Gives the films their circulation at the start; empty: at rest.
  std::function<void(const base::OptionSet&, Simulation&)> set_motion = {};
  /// Where not empty, the surface, its circulation and what is held come from the mesh file that this names, and
  /// `build` is not called.
  std::function<std::string(const base::OptionSet&)> mesh_file = {};
  /// What users should know of such a start; empty: nothing.
  std::function<std::vector<std::string>(const base::OptionSet&)> notes = {};
  /// About how many triangles a run of it has, where users give a number of bubbles; empty: few enough for any machine.
  std::function<double(const base::OptionSet&)> triangles = {};
};

/// The built-in scenes. A new one is a shape and an entry here, or an entry that a program adds to its own catalogue.
const base::Registry<SceneEntry>& built_in_scenes();

}  // namespace foamsim
