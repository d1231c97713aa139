#include "FoamSim/scenes/scene_registry.h"

#include <cmath>

#include "Base/error.h"
#include "FoamSim/scenes/shapes/double_bubble.h"
#include "FoamSim/scenes/shapes/junction_frames.h"
#include "FoamSim/scenes/shapes/solids.h"
#include "FoamSim/scenes/shapes/two_bubbles.h"
#include "LosTopos/shapes/sphere_layout.h"

namespace foamsim {

using base::OptionSet;
using base::OptionSpec;
using base::OptionValue;
using lostopos::SurfaceMesh;

namespace {

OptionSpec whole_between(long least, long most, long default_value, std::string key, std::string summary) {
  return {std::move(key), default_value, std::move(summary),
          "a whole number from " + std::to_string(least) + " to " + std::to_string(most),
          [least, most](const OptionValue& value) {
            return std::get<long>(value) >= least && std::get<long>(value) <= most;
          }};
}

// Beyond eight subdivisions (over a million triangles) direct summation would not end in a lifetime of patience.
OptionSpec subdivisions(long default_value, std::string summary) {
  return whole_between(0, 8, default_value, "n", std::move(summary));
}

OptionSpec displacement(std::string summary) {
  return {"displacement", 0.2, std::move(summary), "a number between -1 and 1",
          [](const OptionValue& value) { return std::abs(std::get<double>(value)) < 1; }};
}

SceneEntry sphere_scene() {
  return {"sphere",
          "one bubble: a sphere, or one of its oscillation modes",
          {subdivisions(3, "subdivisions of an icosahedron (20*4^n triangles)"),
           base::whole_number("mode", 0, 0, "start in this oscillation mode; 0: none"),
           {"amplitude", 0.02, "the mode's amplitude over the radius", "a number between -1 and 1",
            [](const OptionValue& value) { return std::abs(std::get<double>(value)) < 1; }}},
          {{"topology.enabled", false}},
          [](const OptionSet& options) {
            SurfaceMesh mesh = icosphere(options.whole("n"));
            if (const long mode = options.whole("mode"); mode > 0)
              perturb_with_mode(mesh, mode, options.number("amplitude"));
            return mesh;
          }};
}

SceneEntry tet_scene() {
  return {
      "tet",
      "one bubble that starts as a tetrahedron and oscillates",
      {subdivisions(2, "subdivisions of its flat faces (4*4^n triangles); its sharp corners are unstable for n > 2")},
      {{"topology.enabled", false}},
      [](const OptionSet& options) { return tetrahedron(options.whole("n")); }};
}

SceneEntry cube_scene() {
  return {"cube",
          "one bubble that starts as a cube and oscillates",
          {subdivisions(3, "subdivisions of its flat faces (12*4^n triangles)")},
          {{"topology.enabled", false}},
          [](const OptionSet& options) { return cube(options.whole("n")); }};
}

SceneEntry double_bubble_scene() {
  return {"doublebubble",
          "two bubbles that share a wall: the report's case",
          {whole_between(8, 1024, 16, "n", "rings and segments of each bubble (880 triangles for 16)")},
          {{"topology.enabled", false}},
          [](const OptionSet& options) { return double_bubble(options.whole("n")); }};
}

SceneEntry two_bubbles_scene() {
  return {"twobubbles",
          "two bubbles of radius 1 that fly towards each other, meet, and share a wall",
          {subdivisions(3, "subdivisions of each icosahedron (20*4^n triangles)"),
           base::positive_number("gap", 0.1, "distance between the two at the start, L"),
           {"speed", 0.5, "of each towards the other at the start, L/T; 0: at rest", "a finite number"}},
          {},
          [](const OptionSet& options) { return two_bubbles(options.whole("n"), options.number("gap")); },
          [](const OptionSet& options, Simulation& simulation) {
            approach(simulation.mesh(), options.number("gap"), options.number("speed"), simulation.circulation());
          }};
}

SceneEntry foaminit_scene() {
  return {"foaminit",
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

const std::vector<std::string> damped{"surface_tension", "damping", "diffusion"};

SceneEntry triple_junction_scene() {
  return {"triplejunction",
          "three films in a frame whose Plateau border starts bowed and comes to rest straight, at 120 degrees",
          {subdivisions(3, "subdivisions of the films (12*4^n triangles)"),
           displacement("of the border's middle at the start, L")},
          {{"time", 3.0}, {"effects", damped}, {"damping", 0.1}},
          [](const OptionSet& options) {
            return triple_junction_frame(options.whole("n"), options.number("displacement"));
          }};
}

// The vertex has to start inside its frame.
SceneEntry quad_junction_scene() {
  OptionSpec inside{"displacement", 0.2, "of the vertex at the start, L", "a number between -1/3 and 1/3",
                    [](const OptionValue& value) { return std::abs(std::get<double>(value)) < 1.0 / 3; }};
  return {
      "quadjunction",
      "six films in a tetrahedral frame whose Plateau vertex starts off the middle and finds 109.47 degrees",
      {subdivisions(4, "subdivisions of the films (6*4^n triangles)"), std::move(inside)},
      {{"time", 3.0}, {"effects", damped}, {"damping", 0.1}},
      [](const OptionSet& options) { return quad_junction_frame(options.whole("n"), options.number("displacement")); }};
}

}  // namespace

const base::Registry<SceneEntry>& built_in_scenes() {
  static const base::Registry<SceneEntry> scenes(
      "scene", {sphere_scene(), tet_scene(), cube_scene(), double_bubble_scene(), two_bubbles_scene(), foaminit_scene(),
                triple_junction_scene(), quad_junction_scene()});
  return scenes;
}

}  // namespace foamsim
