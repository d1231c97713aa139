#pragma once

#include <string>
#include <vector>

#include "Base/options/option_set.h"
#include "FoamSim/dynamics/simulation.h"
#include "FoamSim/scenes/catalogue.h"
#include "FoamSim/scenes/relaxed_start.h"
#include "FoamSim/scenes/scene_options.h"

namespace foamsim {

/// What is to be simulated: a start surface (a built-in shape or a mesh file) and every option.
struct Scene {
  std::string name;       ///< of the built-in shape, or the mesh file's stem
  std::string mesh_file;  ///< start surface; empty: the built-in shape `name`
  base::OptionSet options;
  std::vector<std::string> notes;              ///< what was read and has no meaning here, for the user to know
  std::shared_ptr<const Catalogue> catalogue;  ///< what its names mean; not null
};

/// A scene that starts from a mesh file, with the defaults.
Scene mesh_scene(const std::string& file, std::shared_ptr<const Catalogue> catalogue = built_in_catalogue());

/// A scene from what a user names: a built-in scene, a .toml scene file, a reference option file (.txt), or a mesh file
/// (.ply, .obj, .rec, .arec) as start surface. Throws base::InputError (unknown name, file and line of what is
/// wrong).
Scene load_scene(const std::string& what, std::shared_ptr<const Catalogue> catalogue = built_in_catalogue());

/// The built-in scene of that name with its defaults. Throws base::InputError with the nearest name.
Scene built_in_scene(std::string_view name, std::shared_ptr<const Catalogue> catalogue = built_in_catalogue());

/// Checks what single options cannot: that each option that is set is read by something that the scene uses. Scenes
/// that are compared have one set of options: `also_used` are area strategies of the others.
void validate(const Scene& scene, std::span<const std::string> also_used = {});

/// The mesh file that it starts from; empty: a built-in shape. Throws base::InputError where its folder lacks it.
std::string start_file(const Scene& scene);

/// The start surface. Throws base::InputError for a bad size or file.
lostopos::SurfaceMesh build_surface(const Scene& scene);

SimulationOptions simulation_options(const base::OptionSet& options);
/// The effects, constraints and dynamics that the scene names. `edges`: where films end.
SimulationParts simulation_parts(const Scene& scene, double resolution, const std::vector<lostopos::Vertex>& edges);

/// The simulation of the scene from its start, relaxed where it asks for that. Validates first. A film that ends at a
/// free edge ends at a frame: the vertices on such edges are held, and so are those that a mesh file says are
/// (constraint "frame").
/// `interruption`: see TrackerOptions, and asked while the start is made, too. Throws base::InputError beyond the
/// option memory_limit, before that memory is taken.
Simulation make_simulation(const Scene& scene, const RelaxationProgress& progress = {},
                           const base::Interruption& interruption = {});
/// The same, at rest, from a given surface (of a checkpoint, say); `resolution` is h̄ (L), `edges` the vertices where
/// films end.
Simulation make_simulation(const Scene& scene, lostopos::SurfaceMesh surface, double resolution,
                           const std::vector<lostopos::Vertex>& edges, const base::Interruption& interruption = {});

}  // namespace foamsim
