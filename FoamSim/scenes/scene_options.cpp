#include "FoamSim/scenes/scene_options.h"

#include <algorithm>

#include "LosTopos/tracker_options.h"

namespace foamsim {
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
      base::whole_number("relax", 0, 0,
                         "steps of dynamics=relaxation before the first: towards equilibrium, at the bubbles' volumes; "
                         "a foam of Voronoi bubbles makes 30 if this is not set"),
      base::whole_number("frame_every", 25, 0, "steps between saved frames; 0: the first and the last only"),
      base::flag("frame_motion", false, "frames with every vertex's velocity and lasting number, for motion blur"),
      base::whole_number("metrics_every", 1, 1, "steps between rows of metrics.csv"),
      base::flag("air_by_stage", false, "measure the air's energy after every stage, at 3 sums a step"),
      base::whole_number("checkpoint_every", 0, 0, "steps between checkpoints; 0: by checkpoint_seconds alone"),
      base::non_negative_number("checkpoint_seconds", 30,
                                "wall time between checkpoints, s, longer where they would take over 1% of it; 0: by "
                                "checkpoint_every and at the end only"),
      base::whole_number("rec_every", 0, 0, "steps between .rec meshes for the reference program; 0: none"),
      base::whole_number("obj_every", 0, 0, "steps between .obj meshes with normals; 0: none"),
      base::flag("vtp", false, "also write .vtp frames and surface.pvd for ParaView"),
      {"fields", std::vector<std::string>{"all"},
       "what .vtp frames have of films and attributes, separated by commas; setting it sets vtp", "names of fields"},
      base::whole_number("seed", 0, 0, "seed of everything random"),
  };
  const auto belongs_to = [&specs](const char* key, base::OptionSpec::Owner owner) {
    std::ranges::find(specs, key, &base::OptionSpec::key)->owner = std::move(owner);
  };
  belongs_to("integrator", {"dynamics", "vortex-sheet"});
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

}  // namespace

bool names_have(std::span<const std::string> names, std::string_view name) {
  return std::ranges::find(names, name) != names.end();
}

bool holds_by_wire(const base::OptionSet& options) {
  return names_have(options.words("constraints"), "wire") || names_have(options.words("constraints"), "rod");
}

std::vector<std::string> effects_of(const base::OptionSet& options) {
  std::vector<std::string> names = options.words("effects");
  if (options.is_set("effects") || options.word("dynamics") == "vortex-sheet") return names;
  std::erase(names, "diffusion");
  if (options.word("dynamics") == "relaxation")
    for (const char* of_air : {"damping", "blow"}) std::erase(names, of_air);
  names.emplace_back("volumes");
  return names;
}

base::OptionSet options_in_use(const base::OptionSet& options) {
  base::OptionSet used = options;
  const auto fill_in = [&used](const char* key, const base::OptionValue& value) {
    if (!used.is_set(key)) used.set_default(key, value);
  };
  fill_in("effects", effects_of(options));
  if (options.has("bubbles") && options.whole("bubbles") > 0) fill_in("relax", 30L);
  if (options.is_set("fields")) fill_in("vtp", true);
  // A wire or rod keeps its vertices, and films near it theirs.
  if (holds_by_wire(options)) fill_in("remeshing.collapse_to_held", false);
  if (options.word("dynamics") != "vortex-sheet") {
    // These keep volumes, so remeshing must not be what changes them; and they rest where the area of the mesh is
    // least, which is the nearer to the films' rest the better its triangles are.
    fill_in("remeshing.max_volume_change", 0.002);
    fill_in("remeshing.smooth_below", 45.0);
    fill_in("remeshing.longest_edge", 1.35);
  }
  if (options.word("dynamics") == "conservative") {
    // Films that vanish become slivers first, which ask for the shorter steps the shorter their edges are.
    fill_in("topology.pull_apart", 0.2);
    fill_in("topology.merge_edge", std::min(0.1, used.number("topology.pull_apart") / 2));
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

}  // namespace foamsim
