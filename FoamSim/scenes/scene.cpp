#include "FoamSim/scenes/scene.h"

#include <algorithm>
#include <filesystem>
#include <optional>

#include "Base/error.h"
#include "Base/options/option_value.h"
#include "FoamSim/scenes/reference_options.h"
#include "FoamSim/scenes/relaxed_start.h"
#include "FoamSim/scenes/scene_memory.h"
#include "FoamSim/scenes/shapes/held.h"
#include "FoamSim/scenes/toml_scene.h"
#include "LosTopos/io/fe.h"
#include "LosTopos/io/mesh_file.h"
#include "LosTopos/io/rec.h"
#include "LosTopos/io/tidy_surface.h"
#include "LosTopos/mesh/measures.h"
#include "LosTopos/tracker_options.h"

namespace foamsim {

using lostopos::Edge;
using lostopos::SurfaceMesh;
using lostopos::Vertex;

namespace {

// With what a file of the reference program holds besides the surface.
struct StartSurface {
  SurfaceMesh mesh;
  lostopos::PairArray circulation = {};
  std::vector<Vertex> held = {};
};

void hold_free_edges(StartSurface& start) {
  for (Edge e : start.mesh.edges())
    if (start.mesh.triangles(e).size() == 1)
      start.held.insert(start.held.end(), start.mesh.vertices(e).begin(), start.mesh.vertices(e).end());
}

// These and what waits in the mesh as held: what a scene's shape marks, or a surface that is on its way.
std::vector<Vertex> with_marked_vertices(SurfaceMesh& mesh, std::vector<Vertex> vertices) {
  auto hold = mesh.add_vertex_attribute<lostopos::Hold>("hold", lostopos::carry::copy, lostopos::Hold::none);
  for (Vertex v : mesh.vertices())
    if (lostopos::is_held(hold[v])) vertices.push_back(v);
  std::move(hold).leave();
  return vertices;
}

// Of the triangles that something of the film moves with, where the file says (Surface Evolver's does).
void require_one_tension(const std::string& file, const lostopos::SurfaceData& data) {
  const auto array = std::ranges::find(data.triangle_arrays, lostopos::tension_array, &lostopos::DataArray::name);
  if (array == data.triangle_arrays.end() || array->components != 1) return;
  std::vector<bool> held(data.positions.size());
  for (const lostopos::HeldVertex& vertex : data.held) held[vertex.vertex] = true;
  std::optional<double> least, most;
  for (std::size_t t = 0; t < data.triangles.size(); ++t) {
    if (std::ranges::all_of(data.triangles[t], [&](std::uint32_t v) { return held[v]; })) continue;
    least = std::min(least.value_or(array->values[t]), array->values[t]);
    most = std::max(most.value_or(array->values[t]), array->values[t]);
  }
  if (least != most)
    throw base::InputError("'" + file + "': films have tensions of " + base::to_text(*least) + " to " +
                           base::to_text(*most) + "; there is one for all here, 'sigma'");
}

StartSurface start_surface(const Scene& scene) {
  const std::string file = start_file(scene);
  if (file.empty()) return {scene.catalogue->scenes.find(scene.name).build(scene.options)};
  lostopos::SurfaceData data = lostopos::read_surface(file);
  require_one_tension(file, data);
  lostopos::tidy_surface(data);
  StartSurface start{lostopos::to_mesh(data)};
  if (const auto* circulation = find_pair_array(data, lostopos::rec_pair_array)) start.circulation = *circulation;
  for (const lostopos::HeldVertex& held : data.held) {
    start.held.emplace_back(held.vertex);
    start.mesh.set_position(Vertex(held.vertex), held.position);
  }
  if (start.held.empty()) return start;
  // In a file of the reference program a triangle with three held corners is part of a solid. A frame marks for itself
  // what it holds.
  if (holds_by_wire(scene.options))
    mark_held(start.mesh, start.held);
  else
    mark_solids(start.mesh, start.held);
  return start;
}

// Of all triangles' three sides, L: an inner edge counts twice, a Plateau border three times.
double mean_side_length(const SurfaceMesh& mesh) {
  double sum = 0;
  for (Edge e : mesh.edges()) sum += lostopos::length(mesh, e) * static_cast<double>(mesh.triangles(e).size());
  return sum / std::max(1.0, 3 * static_cast<double>(mesh.triangle_count()));
}

long relaxation_steps(const base::OptionSet& options) {
  return options_in_use(options).whole("relax");
}

void require_free_to_relax(const Scene& scene, StartSurface& start) {
  if (relaxation_steps(scene.options) == 0) return;
  if (!with_marked_vertices(start.mesh, start.held).empty())
    throw base::InputError("relax is for foams that nothing holds; this start has films that are held, or end freely");
  const bool moves = scene.mesh_file.empty() && scene.catalogue->scenes.find(scene.name).set_motion;
  if (moves || !start.circulation.offsets.empty())
    throw base::InputError("relax is for a start at rest; this one has circulation, which would be lost");
}

void set_start_motion(const Scene& scene, const lostopos::PairArray& given, Simulation& simulation) {
  if (scene.mesh_file.empty() && !scene.catalogue->scenes.find(scene.name).mesh_file) {
    if (const auto& set_motion = scene.catalogue->scenes.find(scene.name).set_motion)
      set_motion(scene.options, simulation);
    return;
  }
  for (std::size_t v = 0; v + 1 < given.offsets.size(); ++v)
    for (const auto& [p, q, value] : given.at(v)) simulation.circulation().set(Vertex(v), {p, q}, value);
  simulation.circulation().match(simulation.mesh());
}

}  // namespace

Scene built_in_scene(std::string_view name, std::shared_ptr<const Catalogue> catalogue) {
  const SceneEntry& entry = catalogue->scenes.find(name);
  base::OptionSet options = options_of(*catalogue, &entry);
  return {entry.name, "", std::move(options), {}, std::move(catalogue)};
}

Scene mesh_scene(const std::string& file, std::shared_ptr<const Catalogue> catalogue) {
  base::OptionSet options = options_of(*catalogue, nullptr);
  return {std::filesystem::path(file).stem().string(), file, std::move(options), {}, std::move(catalogue)};
}

Scene load_scene(const std::string& what, std::shared_ptr<const Catalogue> catalogue) {
  const std::string extension = std::filesystem::path(what).extension().string();
  if (extension == ".toml") return read_toml_scene(what, std::move(catalogue));
  if (extension == ".txt") return read_reference_options(what, std::move(catalogue));
  if (lostopos::find_mesh_format(what) != nullptr) return mesh_scene(what, std::move(catalogue));
  return built_in_scene(what, std::move(catalogue));
}

std::string start_file(const Scene& scene) {
  if (!scene.mesh_file.empty()) return scene.mesh_file;
  const auto& named = scene.catalogue->scenes.find(scene.name).mesh_file;
  return named ? named(scene.options) : std::string();
}

SurfaceMesh build_surface(const Scene& scene) {
  return start_surface(scene).mesh;
}

SimulationOptions simulation_options(const base::OptionSet& given) {
  const base::OptionSet options = options_in_use(given);
  const lostopos::TrackerOptions tracker = lostopos::tracker_options(options, bytes_of_triangle(options));
  return {.dt = options.number("dt"),
          .delta = options.number("delta"),
          .resolution = options.number("resolution"),
          .air_by_stage = options.flag("air_by_stage"),
          .follow_vertices = options.flag("frame_motion"),
          .tracker = tracker};
}

SimulationParts simulation_parts(const Scene& scene, double resolution, const std::vector<Vertex>& edges) {
  const base::OptionSet& options = scene.options;
  const Catalogue& catalogue = *scene.catalogue;
  SimulationParts parts{
      .dynamics =
          catalogue.dynamics.find(options.word("dynamics")).make({options, catalogue.sheet, catalogue.integrators})};
  parts.effects = make_effects(catalogue.effects, effects_of(options),
                               {options, resolution, catalogue.sheet, parts.dynamics->takes_tension()});
  std::vector<std::string> constraints = options.words("constraints");
  if (constraints.empty() && parts.dynamics->needs_held_edges()) constraints.emplace_back("frame");
  for (const ConstraintEntry& entry : catalogue.constraints) {
    if (!names_have(constraints, entry.name)) continue;
    if (auto constraint = entry.make({options, resolution, edges})) parts.constraints.push_back(std::move(constraint));
  }
  return parts;
}

Simulation make_simulation(const Scene& scene, SurfaceMesh surface, double resolution, const std::vector<Vertex>& edges,
                           const base::Interruption& interruption) {
  validate(scene);
  SimulationOptions options = simulation_options(scene.options);
  options.resolution = resolution;
  options.tracker.interruption = interruption;
  lostopos::require_memory(estimated_size(scene.options, surface, resolution), lostopos::memory_limit(scene.options));
  const std::vector<Vertex> held = with_marked_vertices(surface, edges);
  return {std::move(surface), options, simulation_parts(scene, resolution, held)};
}

Simulation make_simulation(const Scene& scene, const RelaxationProgress& progress,
                           const base::Interruption& interruption) {
  validate(scene);
  if (const auto size = estimated_size(scene)) lostopos::require_memory(*size, lostopos::memory_limit(scene.options));
  StartSurface start = start_surface(scene);
  hold_free_edges(start);
  require_free_to_relax(scene, start);
  SimulationOptions options = simulation_options(scene.options);
  if (options.resolution == 0 && scene.options.word("resolution_mean") == "triangle-sides")
    options.resolution = mean_side_length(start.mesh);
  const double resolution = resolved_resolution(options, start.mesh);
  if (const long steps = relaxation_steps(scene.options); steps > 0) {
    options.resolution = resolution;
    options.tracker.interruption = interruption;
    lostopos::require_memory(estimated_size(scene.options, start.mesh, resolution),
                             lostopos::memory_limit(scene.options));
    start.mesh = relaxed_start(std::move(start.mesh), options, scene.options.number("sigma"), steps, progress);
  }
  Simulation simulation = make_simulation(scene, std::move(start.mesh), resolution, start.held, interruption);
  set_start_motion(scene, start.circulation, simulation);
  return simulation;
}

}  // namespace foamsim
