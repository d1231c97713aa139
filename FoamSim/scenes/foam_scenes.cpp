#include "FoamSim/scenes/scene_families.h"
#include "FoamSim/scenes/scene_sizes.h"
#include "FoamSim/scenes/shapes/three_spheres.h"
#include "LosTopos/shapes/sphere_layout.h"

namespace foamsim {

using base::OptionSet;

namespace {

SceneEntry foaminit_scene() {
  return {"foaminit",
          "three spheres that grow until they press each other flat",
          {subdivisions(1, "subdivisions of each icosahedron (20*4^n triangles)")},
          {{"effects", std::vector<std::string>{"growth"}}},
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

}  // namespace

std::vector<SceneEntry> foam_scenes() {
  return {foaminit_scene(), growth_scene()};
}

}  // namespace foamsim
