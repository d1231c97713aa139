#include "FoamSim/scenes/scene.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "Base/error.h"
#include "FoamSim/scenes/reference_options.h"
#include "FoamSim/scenes/shapes/held.h"
#include "FoamSim/scenes/toml_scene.h"
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

base::OptionSpec step_length() {
  auto spec = base::positive_number("dt", 0.01, "length of a step, T; auto: what the films bear (conservative)");
  spec.named_numbers = {{"auto", 0}};
  return spec;
}

std::vector<base::OptionSpec> general_option_specs(const Catalogue& catalogue) {
  using base::name_of;
  std::vector<base::OptionSpec> specs{
      step_length(),
      base::non_negative_number("time", 4, "simulated time, T"),
      base::non_negative_number("resolution", 0, "target mean edge length, L; 0: that of the start mesh"),
      base::word_from("resolution_mean", std::string("edges"), "what a resolution of 0 is the mean of", "mean",
                      {"edges", "triangle-sides"}),
      base::non_negative_number("delta", 0, "regularisation, L; 0: 0.75 resolution, 0.5 for conservative"),
      name_of("dynamics", std::string("vortex-sheet"), "how films move", catalogue.dynamics),
      name_of("integrator", std::string("euler"), "how positions are advanced", catalogue.integrators),
      name_of("velocity", std::string("direct"), "how velocities are summed", catalogue.sheet.velocities),
      name_of("effects", std::vector<std::string>{"surface_tension", "diffusion"},
              "what acts on the films, separated by commas", catalogue.effects),
      name_of("constraints", std::vector<std::string>{"frame"}, "what holds films at their edges",
              catalogue.constraints),
      name_of("pressure", std::string("edge_angle"), "what drives circulation", catalogue.sheet.pressures),
      name_of("area", std::string("averaged"), "area that normalises curvature at junctions", catalogue.sheet.areas),
      base::whole_number("frame_every", 25, 0, "steps between saved frames; 0: the first and the last only"),
      base::whole_number("metrics_every", 1, 1, "steps between rows of metrics.csv"),
      base::whole_number("checkpoint_every", 500, 0, "steps between checkpoints; 0: at the end only"),
      base::whole_number("rec_every", 0, 0, "steps between .rec meshes for the reference program; 0: none"),
      base::whole_number("obj_every", 0, 0, "steps between .obj meshes with normals; 0: none"),
      base::flag("vtp", false, "also write .vtp frames and surface.pvd for ParaView"),
      base::whole_number("seed", 0, 0, "seed of everything random"),
  };
  const auto belongs_to = [&specs](const char* key, base::OptionSpec::Owner owner) {
    std::ranges::find(specs, key, &base::OptionSpec::key)->owner = std::move(owner);
  };
  belongs_to("integrator", {"dynamics", "vortex-sheet"});
  belongs_to("velocity", {"velocities", "sheet"});
  belongs_to("pressure", {"forces", "pressure-scheme"});
  belongs_to("area", {"pressure scheme", "edge_angle"});
  return specs;
}

// Remeshing and topology changes are on unless a scene says otherwise.
lostopos::TrackerOptions tracker_defaults() {
  lostopos::TrackerOptions defaults;
  defaults.topology.enabled = true;
  return defaults;
}

template <class Entry>
void append_options(std::vector<base::OptionSpec>& specs, const base::Registry<Entry>& registry) {
  for (const Entry& entry : registry) specs.insert(specs.end(), entry.options.begin(), entry.options.end());
}

bool contains(std::span<const std::string> words, const std::string& word) {
  return std::ranges::find(words, word) != words.end();
}

bool holds_by_wire(const base::OptionSet& options) {
  return contains(options.words("constraints"), "wire") || contains(options.words("constraints"), "rod");
}

// Whether the scene uses the owner of an option.
bool uses(const base::OptionSet& options, const base::OptionSpec::Owner& owner,
          std::span<const std::string> also_used) {
  const auto& [kind, name] = owner;
  const bool vortex_sheet = options.word("dynamics") == "vortex-sheet";
  const bool sums = vortex_sheet || options.word("velocities") == "sheet";
  const bool presses =
      (vortex_sheet ? !takes_tension(options.word("integrator")) : options.word("forces") == "pressure-scheme") &&
      contains(effects_of(options), "surface_tension");
  if (contains(also_used, name)) return true;
  if (kind == "effect") return contains(effects_of(options), name);
  if (kind == "dynamics") return options.word("dynamics") == name;
  if (kind == "constraint") return contains(options.words("constraints"), name);
  if (kind == "velocities") return sums;
  if (kind == "velocity sum") return sums && options.word("velocity") == name;
  if (kind == "integrator") return vortex_sheet && options.word("integrator") == name;
  if (kind == "forces") return presses;
  if (kind == "pressure scheme") return presses && options.word("pressure") == name;
  if (kind == "area strategy")
    return uses(options, {"pressure scheme", "edge_angle"}, also_used) && options.word("area") == name;
  return true;
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

// These and what waits in the mesh as held: what a scene's shape marks, or a surface that is on its way.
std::vector<Vertex> with_marked_vertices(SurfaceMesh& mesh, std::vector<Vertex> vertices) {
  auto hold = mesh.add_vertex_attribute<lostopos::Hold>("hold", lostopos::carry::copy, lostopos::Hold::none);
  for (Vertex v : mesh.vertices())
    if (lostopos::is_held(hold[v])) vertices.push_back(v);
  std::move(hold).leave();
  return vertices;
}

StartSurface start_surface(const Scene& scene) {
  const std::string file = start_file(scene);
  if (file.empty()) return {scene.catalogue->scenes.find(scene.name).build(scene.options)};
  lostopos::SurfaceData data = lostopos::read_surface(file);
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

// What the conservative dynamics cannot have, and why.
void refuse_for_conservative(const base::OptionSet& options) {
  if (options.word("dynamics") != "conservative") return;
  if (contains(effects_of(options), "diffusion"))
    throw base::InputError(
        "effect 'diffusion' smooths circulation pair by pair, which can win energy, and is not for "
        "dynamics=conservative; "
        "use --set viscosity=ETA (surface viscosity, L^3/T) in its place");
  const double delta = options.number("delta"), resolution = options.number("resolution");
  if (delta > 0 && resolution > 0 && delta < 0.1 * resolution)
    throw base::InputError(
        "delta is below a tenth of the resolution, where slivers make the kinetic energy of "
        "dynamics=conservative as good as singular; leave it out (half the resolution) or give at "
        "least " +
        base::to_text(0.1 * resolution));
}

// What is read by some of its steppings only.
void refuse_for_stepping(const base::OptionSet& options) {
  if (options.word("dynamics") != "conservative" || options.word("stepping") == "kick-drift") return;
  if (options.is_set("correction") && options.flag("correction"))
    throw base::InputError("option 'correction' is for stepping=kick-drift; stepping=" + options.word("stepping") +
                           " keeps energy by its order alone");
}

// Of an option whose owner the scene does not use.
std::string not_used_message(const base::OptionSpec& spec, const base::OptionSet& options) {
  const auto& [kind, name] = spec.owner;
  std::string help;
  if (kind == "pressure scheme" && takes_tension(options.word("integrator")))
    help = "; integrator=" + options.word("integrator") + " has its own curvature and areas";
  else if (kind == "effect")
    help = "; add it with --set effects+=" + name;
  else if (options.word("dynamics") == "conservative" && spec.key == "integrator")
    help = "; dynamics=conservative has --set stepping=kick-drift, midpoint or rk4";
  else if (options.word("dynamics") == "conservative")
    help =
        "; dynamics=conservative has exact forces and the velocities that belong to them (but for --set "
        "forces=pressure-scheme, --set velocities=sheet)";
  return "option '" + spec.key + "' belongs to the " + kind + " '" + name + "', which this scene does not use" + help;
}

}  // namespace

std::vector<std::string> effects_of(const base::OptionSet& options) {
  std::vector<std::string> names = options.words("effects");
  if (options.is_set("effects") || options.word("dynamics") != "conservative") return names;
  std::erase(names, "diffusion");
  names.emplace_back("volumes");
  return names;
}

base::OptionSet options_in_use(const base::OptionSet& options) {
  base::OptionSet used = options;
  const auto fill_in = [&used](const char* key, const base::OptionValue& value) {
    if (!used.is_set(key)) used.set_default(key, value);
  };
  fill_in("effects", effects_of(options));
  // A wire or rod keeps its vertices, and films near it theirs.
  if (holds_by_wire(options)) fill_in("remeshing.collapse_to_held", false);
  if (options.word("dynamics") == "conservative") {
    // The scheme keeps volumes, so remeshing must not be what changes them; and it rests where the area of the mesh is
    // least, which is the nearer to the films' rest the better its triangles are.
    fill_in("remeshing.max_volume_change", 0.002);
    fill_in("remeshing.smooth_below", 45.0);
    fill_in("remeshing.longest_edge", 1.35);
  }
  return used;
}

std::vector<base::OptionSpec> common_option_specs(const Catalogue& catalogue) {
  std::vector<base::OptionSpec> specs = general_option_specs(catalogue);
  for (base::OptionSpec& spec : lostopos::tracker_option_specs(tracker_defaults())) specs.push_back(std::move(spec));
  append_options(specs, catalogue.effects);
  append_options(specs, catalogue.constraints);
  append_options(specs, catalogue.sheet.pressures);
  append_options(specs, catalogue.sheet.areas);
  append_options(specs, catalogue.sheet.velocities);
  append_options(specs, catalogue.integrators);
  append_options(specs, catalogue.dynamics);
  return specs;
}

std::vector<base::OptionSpec> all_option_specs(const Catalogue& catalogue) {
  std::vector<base::OptionSpec> specs;
  const auto add = [&specs](const std::vector<base::OptionSpec>& more) {
    for (const base::OptionSpec& spec : more)
      if (std::ranges::find(specs, spec.key, &base::OptionSpec::key) == specs.end()) specs.push_back(spec);
  };
  for (const SceneEntry& scene : catalogue.scenes) add(scene.options);
  add(common_option_specs(catalogue));
  return specs;
}

base::OptionSet options_of(const Catalogue& catalogue, const SceneEntry* scene) {
  std::vector<base::OptionSpec> specs, elsewhere;
  if (scene != nullptr) specs = scene->options;
  for (base::OptionSpec& spec : common_option_specs(catalogue)) specs.push_back(std::move(spec));
  for (const SceneEntry& other : catalogue.scenes)
    if (scene == nullptr || other.name != scene->name)
      elsewhere.insert(elsewhere.end(), other.options.begin(), other.options.end());
  base::OptionSet options(std::move(specs), "foamsim scenes", std::move(elsewhere));
  if (scene != nullptr)
    for (const auto& [key, value] : scene->defaults) options.set_default(key, value);
  return options;
}

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

void validate(const Scene& scene, std::span<const std::string> also_used) {
  refuse_for_conservative(scene.options);
  refuse_for_stepping(scene.options);
  if (scene.options.number("dt") == 0 && scene.options.word("dynamics") == "vortex-sheet")
    throw base::InputError(
        "dt=auto is for dynamics=conservative, whose longest stable step is known; with dynamics=vortex-sheet give dt "
        "as a number: 0.9 h^1.5 / sqrt(sigma) for edges of a length h is near what it bears");
  for (const base::OptionSpec& spec : scene.options.specs()) {
    const auto& [kind, name] = spec.owner;
    if (kind.empty() || !scene.options.is_set(spec.key) || uses(scene.options, spec.owner, also_used)) continue;
    throw base::InputError(not_used_message(spec, scene.options));
  }
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
  const lostopos::TrackerOptions tracker = lostopos::tracker_options(options);
  return {.dt = options.number("dt"),
          .delta = options.number("delta"),
          .resolution = options.number("resolution"),
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
  for (const ConstraintEntry& entry : catalogue.constraints) {
    if (!contains(options.words("constraints"), entry.name)) continue;
    if (auto constraint = entry.make({options, resolution, edges})) parts.constraints.push_back(std::move(constraint));
  }
  return parts;
}

Simulation make_simulation(const Scene& scene, SurfaceMesh surface, double resolution,
                           const std::vector<Vertex>& edges) {
  validate(scene);
  SimulationOptions options = simulation_options(scene.options);
  options.resolution = resolution;
  const std::vector<Vertex> held = with_marked_vertices(surface, edges);
  return {std::move(surface), options, simulation_parts(scene, resolution, held)};
}

Simulation make_simulation(const Scene& scene) {
  validate(scene);
  StartSurface start = start_surface(scene);
  hold_free_edges(start);
  SimulationOptions options = simulation_options(scene.options);
  if (options.resolution == 0 && scene.options.word("resolution_mean") == "triangle-sides")
    options.resolution = mean_side_length(start.mesh);
  const double resolution = resolved_resolution(options, start.mesh);
  Simulation simulation = make_simulation(scene, std::move(start.mesh), resolution, start.held);
  set_start_motion(scene, start.circulation, simulation);
  return simulation;
}

}  // namespace foamsim
