#pragma once

#include <string>
#include <vector>

#include "Base/options/option_set.h"
#include "FoamSim/dynamics/simulation.h"

namespace foamsim {

/// What is to be simulated: a start surface (a built-in shape or a mesh file) and every option.
struct Scene {
  std::string name;       ///< of the built-in shape, or the mesh file's stem
  std::string mesh_file;  ///< start surface; empty: the built-in shape `name`
  base::OptionSet options;
  std::vector<std::string> notes;  ///< what was read and has no meaning here, for the user to know
};

/// The options that every scene has, with their defaults: the general ones and those of every effect.
std::vector<base::OptionSpec> scene_option_specs();

/// A scene from what a user names: a built-in scene, a .toml scene file, a reference option file (.txt), or a mesh file
/// (.ply, .obj, .rec, .arec) as start surface. Throws base::InputError (unknown name, file and line of what is
/// wrong).
Scene load_scene(const std::string& what);

/// The built-in scene of that name with its defaults. Throws base::InputError with the nearest name.
Scene built_in_scene(std::string_view name);

/// Checks what single options cannot: effects and strategies exist, options belong to effects that the scene names.
void validate(const Scene& scene);

/// The start surface. Throws base::InputError for a bad size or file.
lostopos::SurfaceMesh build_surface(const Scene& scene);

SimulationOptions simulation_options(const base::OptionSet& options);

/// The simulation of the scene from its start. Validates first. A film that ends at a free edge ends at a frame: the
/// vertices on such edges are held, and so are those that a mesh file says are.
Simulation make_simulation(const Scene& scene);
/// The same, at rest, from a given surface (of a checkpoint, say); `resolution` is h̄ (L), `held` the vertices that are
/// held.
Simulation make_simulation(const Scene& scene, lostopos::SurfaceMesh surface, double resolution,
                           std::span<const lostopos::Vertex> held);

}  // namespace foamsim
