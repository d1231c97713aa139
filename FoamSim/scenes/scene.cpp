#include "FoamSim/scenes/scene.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "FoamSim/effects/registry.h"
#include "FoamSim/names/nearest_name.h"
#include "FoamSim/scenes/reference_options.h"
#include "FoamSim/scenes/scene_registry.h"
#include "FoamSim/scenes/toml_scene.h"
#include "FoamSim/sheet/vertex_area/registry.h"
#include "LosTopos/error.h"
#include "LosTopos/io/mesh_file.h"

namespace foamsim {

using lostopos::InputError;
using lostopos::SurfaceMesh;
using lostopos::Vertex;

namespace {

std::vector<OptionSpec> general_option_specs() {
  return {
      whole_number("n", 3, 0, "size of the built-in shape (see 'foamsim scenes')"),
      whole_number("mode", 0, 0, "sphere: start in this oscillation mode; 0: none"),
      {"amplitude", 0.02, "sphere: the mode's amplitude over the radius", "a number between -1 and 1",
       [](const OptionValue& value) { return std::abs(std::get<double>(value)) < 1; }},
      positive_number("dt", 0.01, "length of a step, T"),
      non_negative_number("time", 4, "simulated time, T"),
      non_negative_number("resolution", 0, "target mean edge length, L; 0: that of the start mesh"),
      non_negative_number("delta", 0, "Biot-Savart regularisation, L; 0: 0.75 resolution"),
      {"integrator", std::string("euler"), "euler or rk4", "euler or rk4"},
      {"effects", std::vector<std::string>{"surface_tension", "diffusion"},
       "what acts on the films, separated by commas", "names from 'foamsim effects'"},
      whole_number("frame_every", 25, 0, "steps between saved frames; 0: the first and the last only"),
      whole_number("metrics_every", 1, 1, "steps between rows of metrics.csv"),
      whole_number("checkpoint_every", 500, 0, "steps between checkpoints; 0: at the end only"),
      flag("vtp", false, "also write .vtp frames and surface.pvd for ParaView"),
      whole_number("seed", 0, 0, "seed of everything random"),
  };
}

// Bounds of the tracker (METHOD "Moving without intersection" and "Remeshing and topology"), relative to h̄.
std::vector<OptionSpec> tracker_option_specs() {
  const lostopos::TrackerOptions d;
  return {
      flag("tracker.collisions", d.collisions, "keep the films from intersecting"),
      non_negative_number("tracker.proximity", d.proximity_epsilon,
                          "films nearer than this are pushed apart, in resolutions"),
      flag("remeshing.enabled", true, "split, collapse, flip and smooth triangles after every step"),
      whole_number("remeshing.iterations", d.remeshing_iterations, 1, "remeshing passes a step"),
      positive_number("remeshing.shortest_edge", d.remesh.shortest_edge, "shorter edges are collapsed, in resolutions"),
      positive_number("remeshing.longest_edge", d.remesh.longest_edge, "longer edges are split, in resolutions"),
      positive_number("remeshing.min_area", d.remesh.min_area, "no smaller triangle is made, in resolutions squared"),
      positive_number("remeshing.min_angle", d.remesh.min_angle, "no smaller angle is made, degrees"),
      positive_number("remeshing.max_angle", d.remesh.max_angle, "no larger angle is made, degrees"),
      positive_number("remeshing.split_angle", d.remesh.split_angle,
                      "the edge opposite to a larger angle is split, degrees"),
      positive_number("remeshing.max_volume_change", d.remesh.max_volume_change,
                      "largest change of a volume by an operation, in resolutions cubed"),
      flag("remeshing.smoothing", d.remesh.smoothing, "smooth badly shaped triangles along the films"),
      flag("remeshing.butterfly", d.remesh.use_butterfly, "curved positions for new vertices; false: midpoints"),
  };
}

lostopos::TrackerOptions tracker_options(const OptionSet& options) {
  lostopos::TrackerOptions tracker;
  tracker.collisions = options.flag("tracker.collisions");
  tracker.proximity_epsilon = options.number("tracker.proximity");
  tracker.remeshing = options.flag("remeshing.enabled");
  tracker.remeshing_iterations = static_cast<int>(options.whole("remeshing.iterations"));
  tracker.remesh.shortest_edge = options.number("remeshing.shortest_edge");
  tracker.remesh.longest_edge = options.number("remeshing.longest_edge");
  tracker.remesh.min_area = options.number("remeshing.min_area");
  tracker.remesh.min_angle = options.number("remeshing.min_angle");
  tracker.remesh.max_angle = options.number("remeshing.max_angle");
  tracker.remesh.split_angle = options.number("remeshing.split_angle");
  tracker.remesh.max_volume_change = options.number("remeshing.max_volume_change");
  tracker.remesh.smoothing = options.flag("remeshing.smoothing");
  tracker.remesh.use_butterfly = options.flag("remeshing.butterfly");
  return tracker;
}

void require_known_names(const OptionSet& options) {
  for (const std::string& effect : options.words("effects")) find_by_name(effect_entries(), effect, "effect");
  find_by_name(vertex_area_strategies(), options.word("area"), "area strategy");
  integrator_by_name(options.word("integrator"));
}

// `circulation` (may be null) receives what a file of the reference program holds besides the surface.
SurfaceMesh start_surface(const Scene& scene, lostopos::PairValues* circulation) {
  if (scene.mesh_file.empty()) return scene_by_name(scene.name).build(scene.options);
  lostopos::SurfaceData data = lostopos::read_surface(scene.mesh_file);
  if (circulation != nullptr) *circulation = std::move(data.circulation);
  return lostopos::to_mesh(data);
}

}  // namespace

std::vector<OptionSpec> scene_option_specs() {
  std::vector<OptionSpec> specs = general_option_specs();
  for (OptionSpec& spec : tracker_option_specs()) specs.push_back(std::move(spec));
  for (const EffectEntry& effect : effect_entries())
    specs.insert(specs.end(), effect.options.begin(), effect.options.end());
  return specs;
}

Scene built_in_scene(std::string_view name) {
  const SceneEntry& entry = scene_by_name(name);
  Scene scene{std::string(entry.name), "", OptionSet(scene_option_specs()), {}};
  for (const auto& [key, value] : entry.defaults) scene.options.set_default(key, value);
  return scene;
}

Scene load_scene(const std::string& what) {
  const std::filesystem::path path(what);
  const std::string extension = path.extension().string();
  if (extension == ".toml") return read_toml_scene(what);
  if (extension == ".txt") return read_reference_options(what);
  if (lostopos::find_mesh_format(what) != nullptr)
    return {path.stem().string(), what, OptionSet(scene_option_specs()), {}};
  return built_in_scene(what);
}

void validate(const Scene& scene) {
  require_known_names(scene.options);
  const auto& active = scene.options.words("effects");
  for (const OptionSpec& spec : scene.options.specs()) {
    if (spec.effect.empty() || !scene.options.is_set(spec.key)) continue;
    if (std::ranges::find(active, spec.effect) == active.end())
      throw InputError("option '" + spec.key + "' belongs to the effect '" + spec.effect +
                       "', which this scene does not use; add it with --set effects+=" + spec.effect);
  }
}

SurfaceMesh build_surface(const Scene& scene) {
  return start_surface(scene, nullptr);
}

SimulationOptions simulation_options(const OptionSet& options) {
  return {.dt = options.number("dt"),
          .delta = options.number("delta"),
          .resolution = options.number("resolution"),
          .integrator = integrator_by_name(options.word("integrator")),
          .tracker = tracker_options(options)};
}

Simulation make_simulation(const Scene& scene, SurfaceMesh surface, double resolution) {
  validate(scene);
  SimulationOptions options = simulation_options(scene.options);
  options.resolution = resolution;
  return {std::move(surface), options, make_effects(scene.options.words("effects"), {scene.options, resolution})};
}

Simulation make_simulation(const Scene& scene) {
  validate(scene);
  lostopos::PairValues circulation;
  SurfaceMesh surface = start_surface(scene, &circulation);
  const double resolution = resolved_resolution(simulation_options(scene.options), surface);
  Simulation simulation = make_simulation(scene, std::move(surface), resolution);
  for (std::size_t v = 0; v + 1 < circulation.offsets.size(); ++v)
    for (const auto& [p, q, value] : circulation.at(v)) simulation.circulation().set(Vertex(v), {p, q}, value);
  simulation.circulation().match(simulation.mesh());
  return simulation;
}

}  // namespace foamsim
