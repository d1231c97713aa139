#include "Base/error.h"
#include "FoamSim/scenes/foam_start.h"
#include "FoamSim/scenes/scene_families.h"
#include "FoamSim/scenes/scene_sizes.h"
#include "FoamSim/scenes/shapes/pulling_rings.h"
#include "FoamSim/scenes/shapes/three_spheres.h"
#include "LosTopos/shapes/sphere_layout.h"

namespace foamsim {

using base::OptionSet;
using lostopos::SurfaceMesh;

namespace {

SceneEntry foaminit_scene() {
  return {"foaminit",
          "three spheres that grow until they press each other flat",
          {subdivisions(1, "subdivisions of each icosahedron (20*4^n triangles)")},
          // The rates of a clock that has one tick a step, where the published one has two.
          {{"effects", std::vector<std::string>{"surface_tension", "damping", "diffusion", "growth"}},
           {"damping", 0.001},
           {"diffusion", 20.0},
           {"growth", 0.2},
           {"growth_normals", std::string("unit")}},
          [](const OptionSet& options) { return three_spheres(options.whole("n")); }};
}

SceneEntry growth_scene() {
  return {.name = "growth",
          .summary = "spheres that grow until they have pressed each other into a foam; its last frame is a start mesh",
          .options = {whole_between(1, 1'000'000, 8, "spheres", "number of spheres (320 triangles each)"),
                      base::word_from("layout", std::string("grid"), "where they are: grid (jittered) or random",
                                      "layout", {"grid", "random"})},
          .defaults = {{"time", 0.8}, {"effects", std::vector<std::string>{"growth"}}},
          .build =
              [](const OptionSet& options) {
                return lostopos::sphere_meshes(
                    lostopos::sphere_layout({.spheres = options.whole("spheres"),
                                             .layout = lostopos::sphere_layout_by_name(options.word("layout")),
                                             .seed = static_cast<std::uint64_t>(options.whole("seed"))}));
              },
          .triangles = [](const OptionSet& options) { return 320.0 * static_cast<double>(options.whole("spheres")); }};
}

constexpr const char* foam_file = "mesh001000.rec";

base::OptionSpec load_dir(const std::string& file, const std::string& otherwise) {
  return {"load_dir", std::string(), "folder of a run of the reference program, for its " + file + otherwise, "", {}};
}

std::vector<base::OptionSpec> start_of_foam(const std::string& otherwise) {
  return {load_dir(foam_file, "; empty: a foam is " + otherwise),
          whole_between(2, 1000, 8, "spheres", "number of spheres, where a foam is grown")};
}

std::uint64_t seed_of(const OptionSet& options) {
  return static_cast<std::uint64_t>(options.whole("seed"));
}

SurfaceMesh loaded_or_grown_foam(const OptionSet& options) {
  if (!options.word("load_dir").empty()) return mesh_of_run(options.word("load_dir"), foam_file);
  return grown_foam(options.whole("spheres"), seed_of(options));
}

std::vector<base::OptionSpec> options_of_foam() {
  std::vector<base::OptionSpec> options = start_of_foam("made of bubbles, or grown from spheres");
  options.push_back(whole_between(0, 1'000'000, 0, "bubbles",
                                  "bubbles of a foam of random Voronoi cells in a box; 0: it is grown from spheres"));
  options.push_back(whole_between(0, 1000, 3, "relaxations", "rounds that make these bubbles more alike"));
  return options;
}

SurfaceMesh foam(const OptionSet& options) {
  const long bubbles = options.whole("bubbles");
  for (const char* other : {"load_dir", "spheres"})
    if (bubbles > 0 && options.is_set(other))
      throw base::InputError("options 'bubbles' and '" + std::string(other) + "' are two starts of one foam; give one");
  if (bubbles == 0 && options.is_set("relaxations"))
    throw base::InputError("option 'relaxations' is for a foam of Voronoi cells; give a number of bubbles too");
  if (bubbles == 0) return loaded_or_grown_foam(options);
  return voronoi_bubbles(bubbles, static_cast<int>(options.whole("relaxations")), seed_of(options));
}

// At edges of a length h: films have 1.72 of area a bubble, and triangles 0.43 h².
double triangles_of_foam(const OptionSet& options) {
  const double h = options.number("resolution") > 0 ? options.number("resolution") : 0.15;
  return 1.72 / (0.43 * h * h) * static_cast<double>(options.whole("bubbles"));
}

std::vector<std::string> note_on_foam(const OptionSet& options) {
  if (!options.word("load_dir").empty()) return {};
  if (options.has("bubbles") && options.whole("bubbles") > 0) return {};
  return {"load_dir is not set: the foam has been made of " + std::to_string(options.whole("spheres")) +
          " spheres that grew until they met (spheres, seed)"};
}

SceneEntry foam_scene() {
  return {.name = "foam",
          .summary = "a foam whose bubbles burst, one after the other",
          .options = options_of_foam(),
          .defaults = {{"time", 6.0},
                       {"velocity", std::string("auto")},
                       {"effects", std::vector<std::string>{"surface_tension", "diffusion", "burst"}},
                       {"diffusion", 20.0},
                       {"resolution", 0.15}},
          .build = foam,
          .notes = note_on_foam,
          .triangles = triangles_of_foam};
}

SceneEntry pulling_foam_scene() {
  return {.name = "pullingfoam",
          .summary = "a foam held by two rings that are pulled apart",
          .options = start_of_foam("grown from spheres"),
          .defaults = {{"time", 2.0},
                       {"diffusion", 20.0},
                       {"resolution", 0.15},
                       {"constraints", std::vector<std::string>{"wire"}},
                       {"wires", std::vector<std::string>{"held: pull 0.04"}}},
          .build =
              [](const OptionSet& options) {
                SurfaceMesh mesh = loaded_or_grown_foam(options);
                hold_by_rings(mesh);
                return mesh;
              },
          .notes = note_on_foam};
}

SceneEntry load_scene_entry() {
  constexpr const char* file = "mesh000000.rec";
  return {.name = "load",
          .summary = "a mesh that a run of the reference program has left, with its circulation and held vertices",
          .options = {load_dir(file, "")},
          .defaults = {},
          .build = {},
          .mesh_file = [](const OptionSet& options) { return path_of_mesh(options.word("load_dir"), file); }};
}

}  // namespace

std::vector<SceneEntry> foam_scenes() {
  return {sized(foaminit_scene(), triangles_of_subdivided(60)), growth_scene(), foam_scene(), pulling_foam_scene(),
          load_scene_entry()};
}

}  // namespace foamsim
