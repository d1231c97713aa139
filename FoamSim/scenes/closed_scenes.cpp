#include "FoamSim/scenes/approach.h"
#include "FoamSim/scenes/scene_families.h"
#include "FoamSim/scenes/scene_sizes.h"
#include "FoamSim/scenes/shapes/double_bubble.h"
#include "FoamSim/scenes/shapes/solids.h"
#include "FoamSim/scenes/shapes/two_bubbles.h"

namespace foamsim {

using base::OptionSet;
using lostopos::SurfaceMesh;

namespace {

SceneEntry sphere_scene() {
  return {"sphere",
          "one bubble that starts as the ellipsoid (0.4, 1, 1) and oscillates",
          {subdivisions(3, "subdivisions of an icosahedron (20*4^n triangles)")},
          {{"topology.enabled", false}},
          [](const OptionSet& options) {
            return ellipsoid(options.whole("n"), {0.4, 1, 1});
          }};
}

SceneEntry mode_scene() {
  return {"mode",
          "one bubble: a sphere, or one of its oscillation modes",
          {subdivisions(3, "subdivisions of an icosahedron (20*4^n triangles)"),
           whole_between(0, 100, 0, "mode", "start in this oscillation mode; 0: none"),
           number_below(1, "1", "amplitude", 0.02, "the mode's amplitude over the radius")},
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
      [](const OptionSet& options) { return mirrored(tetrahedron(options.whole("n"))); }};
}

SceneEntry cube_scene() {
  return {"cube",
          "one bubble that starts as a cube and oscillates",
          {subdivisions(3, "subdivisions of its flat faces (12*4^n triangles)")},
          {{"topology.enabled", false}},
          [](const OptionSet& options) { return cube(options.whole("n")); }};
}

base::OptionSpec segments_or_rings() {
  return {"m", 0L, "vertices of each ring; 0: as many as rings", "a whole number from 3 to 1024, or 0",
          [](const base::OptionValue& value) {
            const long m = std::get<long>(value);
            return m == 0 || (m >= 3 && m <= 1024);
          }};
}

SceneEntry double_bubble_scene() {
  return {"doublebubble",
          "two bubbles that share a wall: the report's case",
          {whole_between(8, 512, 16, "n", "rings of each bubble from pole to pole (880 triangles for 16)"),
           segments_or_rings()},
          {{"topology.enabled", false}},
          [](const OptionSet& options) { return double_bubble(options.whole("n"), options.whole("m")); }};
}

SceneEntry two_bubbles_scene() {
  return {"twobubbles",
          "two ellipsoids (0.7, 1, 1) at rest, so near that they meet while they become round, and share a wall",
          {subdivisions(2, "subdivisions of each icosahedron (20*4^n triangles)")},
          {},
          [](const OptionSet& options) {
            SurfaceMesh mesh = two_bubbles(options.whole("n"), 0.04);
            scale(mesh, {0.7, 1, 1});
            return mesh;
          }};
}

SceneEntry headon_scene() {
  return {"headon",
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

}  // namespace

std::vector<SceneEntry> closed_scenes() {
  return {sized(sphere_scene(), triangles_of_subdivided(20)),  sized(mode_scene(), triangles_of_subdivided(20)),
          sized(tet_scene(), triangles_of_subdivided(4)),      sized(cube_scene(), triangles_of_subdivided(12)),
          sized(double_bubble_scene(), triangles_of_rings(2)), sized(two_bubbles_scene(), triangles_of_subdivided(40)),
          sized(headon_scene(), triangles_of_subdivided(40))};
}

}  // namespace foamsim
