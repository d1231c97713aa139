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
  return {"growth",
          "spheres that grow until they have pressed each other into a foam; its last frame is a start mesh",
          {base::whole_number("spheres", 8, 1, "number of spheres (320 triangles each)"),
           base::word_from("layout", std::string("grid"), "where they are: grid (jittered) or random", "layout",
                           {"grid", "random"})},
          {{"time", 0.8}, {"effects", std::vector<std::string>{"growth"}}},
          [](const OptionSet& options) {
            return lostopos::sphere_meshes(
                lostopos::sphere_layout({.spheres = options.whole("spheres"),
                                         .layout = lostopos::sphere_layout_by_name(options.word("layout")),
                                         .seed = static_cast<std::uint64_t>(options.whole("seed"))}));
          }};
}

constexpr const char* foam_file = "mesh001000.rec";

base::OptionSpec load_dir(const std::string& file, const std::string& otherwise) {
  return {"load_dir", std::string(), "folder of a run of the reference program, for its " + file + otherwise, "", {}};
}

std::vector<base::OptionSpec> start_of_foam() {
  return {load_dir(foam_file, "; empty: a foam is grown from spheres"),
          whole_between(2, 1000, 8, "spheres", "number of spheres, where a foam is grown")};
}

SurfaceMesh foam(const OptionSet& options) {
  if (!options.word("load_dir").empty()) return mesh_of_run(options.word("load_dir"), foam_file);
  return grown_foam(options.whole("spheres"), static_cast<std::uint64_t>(options.whole("seed")));
}

std::vector<std::string> note_on_foam(const OptionSet& options) {
  if (!options.word("load_dir").empty()) return {};
  return {"load_dir is not set: the foam has been made of " + std::to_string(options.whole("spheres")) +
          " spheres that grew until they met (spheres, seed)"};
}

SceneEntry foam_scene() {
  return {.name = "foam",
          .summary = "a foam whose bubbles burst, one after the other",
          .options = start_of_foam(),
          .defaults = {{"time", 6.0},
                       {"effects", std::vector<std::string>{"surface_tension", "diffusion", "burst"}},
                       {"diffusion", 20.0},
                       {"resolution", 0.15}},
          .build = foam,
          .notes = note_on_foam};
}

SceneEntry pulling_foam_scene() {
  return {.name = "pullingfoam",
          .summary = "a foam held by two rings that are pulled apart",
          .options = start_of_foam(),
          .defaults = {{"time", 2.0},
                       {"diffusion", 20.0},
                       {"resolution", 0.15},
                       {"constraints", std::vector<std::string>{"wire"}},
                       {"wires", std::vector<std::string>{"held: pull 0.04"}}},
          .build =
              [](const OptionSet& options) {
                SurfaceMesh mesh = foam(options);
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
  return {foaminit_scene(), growth_scene(), foam_scene(), pulling_foam_scene(), load_scene_entry()};
}

}  // namespace foamsim
