#include "FoamSim/scenes/scene.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "Base/error.h"
#include "Base/names/nearest_name.h"
#include "FoamSim/effects/registry.h"
#include "FoamSim/scenes/reference_options.h"
#include "FoamSim/scenes/scene_registry.h"
#include "FoamSim/scenes/toml_scene.h"
#include "FoamSim/sheet/pressure/vertex_area/registry.h"
#include "LosTopos/io/mesh_file.h"
#include "LosTopos/io/rec.h"
#include "LosTopos/tracker_options.h"

namespace foamsim {

using lostopos::Edge;
using lostopos::SurfaceMesh;
using lostopos::Vertex;

namespace {

std::vector<base::OptionSpec> general_option_specs() {
  return {
      base::whole_number("n", 3, 0, "size of the built-in shape (see 'foamsim scenes')"),
      base::whole_number("mode", 0, 0, "sphere: start in this oscillation mode; 0: none"),
      {"amplitude", 0.02, "sphere: the mode's amplitude over the radius", "a number between -1 and 1",
       [](const base::OptionValue& value) { return std::abs(std::get<double>(value)) < 1; }},
      base::positive_number("gap", 0.1, "twobubbles: distance between the two at the start, L"),
      {"speed", 0.5, "twobubbles: of each towards the other at the start, L/T; 0: at rest", "a finite number"},
      base::whole_number("spheres", 8, 1, "foaminit: number of spheres"),
      {"layout", std::string("grid"), "foaminit: grid (jittered) or random", "grid or random",
       [](const base::OptionValue& value) {
         return std::get<std::string>(value) == "grid" || std::get<std::string>(value) == "random";
       }},
      {"displacement", 0.2, "triplejunction, quadjunction: of the junction at the start, L",
       "a number between -1 and 1",
       [](const base::OptionValue& value) { return std::abs(std::get<double>(value)) < 1; }},
      base::positive_number("dt", 0.01, "length of a step, T"),
      base::non_negative_number("time", 4, "simulated time, T"),
      base::non_negative_number("resolution", 0, "target mean edge length, L; 0: that of the start mesh"),
      base::non_negative_number("delta", 0, "Biot-Savart regularisation, L; 0: 0.75 resolution"),
      {"integrator", std::string("euler"), "euler or rk4", "euler or rk4"},
      {"effects", std::vector<std::string>{"surface_tension", "diffusion"},
       "what acts on the films, separated by commas", "names from 'foamsim effects'"},
      base::whole_number("frame_every", 25, 0, "steps between saved frames; 0: the first and the last only"),
      base::whole_number("metrics_every", 1, 1, "steps between rows of metrics.csv"),
      base::whole_number("checkpoint_every", 500, 0, "steps between checkpoints; 0: at the end only"),
      base::flag("vtp", false, "also write .vtp frames and surface.pvd for ParaView"),
      base::whole_number("seed", 0, 0, "seed of everything random"),
  };
}

// Remeshing and topology changes are on unless a scene says otherwise.
lostopos::TrackerOptions tracker_defaults() {
  lostopos::TrackerOptions defaults;
  defaults.topology.enabled = true;
  return defaults;
}

void require_known_names(const base::OptionSet& options) {
  for (const std::string& effect : options.words("effects")) base::find_by_name(effect_entries(), effect, "effect");
  base::find_by_name(vertex_area_strategies(), options.word("area"), "area strategy");
  integrator_by_name(options.word("integrator"));
}

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

// In a file of the reference program a triangle with three held corners is part of a solid; the tracker takes over what
// waits in the mesh.
void mark_solids(StartSurface& start) {
  std::vector<char> is_held(start.mesh.vertex_slots(), 0);
  for (Vertex v : start.held) is_held[v.index()] = 1;
  auto solid = start.mesh.add_triangle_attribute<std::uint8_t>("solid", lostopos::carry::copy);
  for (lostopos::Triangle t : start.mesh.triangles())
    solid[t] = std::ranges::all_of(start.mesh.vertices(t), [&](Vertex v) { return is_held[v.index()] != 0; }) ? 1 : 0;
  std::move(solid).leave();
}

StartSurface start_surface(const Scene& scene) {
  if (scene.mesh_file.empty()) return {scene_by_name(scene.name).build(scene.options)};
  lostopos::SurfaceData data = lostopos::read_surface(scene.mesh_file);
  StartSurface start{lostopos::to_mesh(data)};
  if (const auto* circulation = find_pair_array(data, lostopos::rec_pair_array)) start.circulation = *circulation;
  for (const lostopos::HeldVertex& held : data.held) {
    start.held.emplace_back(held.vertex);
    start.mesh.set_position(Vertex(held.vertex), held.position);
  }
  if (!start.held.empty()) mark_solids(start);
  return start;
}

void set_start_motion(const Scene& scene, const lostopos::PairArray& given, Simulation& simulation) {
  if (scene.mesh_file.empty()) {
    if (const auto set_motion = scene_by_name(scene.name).set_motion) set_motion(scene.options, simulation);
    return;
  }
  for (std::size_t v = 0; v + 1 < given.offsets.size(); ++v)
    for (const auto& [p, q, value] : given.at(v)) simulation.circulation().set(Vertex(v), {p, q}, value);
  simulation.circulation().match(simulation.mesh());
}

}  // namespace

std::vector<base::OptionSpec> scene_option_specs() {
  std::vector<base::OptionSpec> specs = general_option_specs();
  for (base::OptionSpec& spec : lostopos::tracker_option_specs(tracker_defaults())) specs.push_back(std::move(spec));
  for (const EffectEntry& effect : effect_entries())
    specs.insert(specs.end(), effect.options.begin(), effect.options.end());
  return specs;
}

Scene built_in_scene(std::string_view name) {
  const SceneEntry& entry = scene_by_name(name);
  Scene scene{std::string(entry.name), "", base::OptionSet(scene_option_specs(), "foamsim scenes"), {}};
  for (const auto& [key, value] : entry.defaults) scene.options.set_default(key, value);
  return scene;
}

Scene load_scene(const std::string& what) {
  const std::filesystem::path path(what);
  const std::string extension = path.extension().string();
  if (extension == ".toml") return read_toml_scene(what);
  if (extension == ".txt") return read_reference_options(what);
  if (lostopos::find_mesh_format(what) != nullptr)
    return {path.stem().string(), what, base::OptionSet(scene_option_specs(), "foamsim scenes"), {}};
  return built_in_scene(what);
}

void validate(const Scene& scene) {
  require_known_names(scene.options);
  const auto& active = scene.options.words("effects");
  for (const base::OptionSpec& spec : scene.options.specs()) {
    if (spec.effect.empty() || !scene.options.is_set(spec.key)) continue;
    if (std::ranges::find(active, spec.effect) == active.end())
      throw base::InputError("option '" + spec.key + "' belongs to the effect '" + spec.effect +
                             "', which this scene does not use; add it with --set effects+=" + spec.effect);
  }
}

SurfaceMesh build_surface(const Scene& scene) {
  return start_surface(scene).mesh;
}

SimulationOptions simulation_options(const base::OptionSet& options) {
  return {.dt = options.number("dt"),
          .delta = options.number("delta"),
          .resolution = options.number("resolution"),
          .integrator = integrator_by_name(options.word("integrator")),
          .tracker = lostopos::tracker_options(options)};
}

Simulation make_simulation(const Scene& scene, SurfaceMesh surface, double resolution, std::span<const Vertex> held) {
  validate(scene);
  SimulationOptions options = simulation_options(scene.options);
  options.resolution = resolution;
  return {std::move(surface), options, make_effects(scene.options.words("effects"), {scene.options, resolution}), held};
}

Simulation make_simulation(const Scene& scene) {
  validate(scene);
  StartSurface start = start_surface(scene);
  hold_free_edges(start);
  const double resolution = resolved_resolution(simulation_options(scene.options), start.mesh);
  Simulation simulation = make_simulation(scene, std::move(start.mesh), resolution, start.held);
  set_start_motion(scene, start.circulation, simulation);
  return simulation;
}

}  // namespace foamsim
