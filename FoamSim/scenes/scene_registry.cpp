#include "FoamSim/scenes/scene_registry.h"

#include <cmath>

#include "Base/error.h"
#include "Base/names/nearest_name.h"
#include "FoamSim/scenes/shapes/double_bubble.h"
#include "FoamSim/scenes/shapes/junction_frames.h"
#include "FoamSim/scenes/shapes/solids.h"
#include "FoamSim/scenes/shapes/two_bubbles.h"
#include "LosTopos/shapes/sphere_layout.h"

namespace foamsim {

using lostopos::SurfaceMesh;

namespace {

// Beyond eight subdivisions (over a million triangles) direct summation would not end in a lifetime of patience.
long subdivisions(const base::OptionSet& options) {
  const long n = options.whole("n");
  if (n > 8) throw base::InputError("n = " + std::to_string(n) + " subdivisions are too many here; n has to be 0 to 8");
  return n;
}

SurfaceMesh build_sphere(const base::OptionSet& options) {
  SurfaceMesh mesh = icosphere(subdivisions(options));
  if (const long mode = options.whole("mode"); mode > 0) perturb_with_mode(mesh, mode, options.number("amplitude"));
  return mesh;
}

SurfaceMesh build_double_bubble(const base::OptionSet& options) {
  const long n = options.whole("n");
  if (n < 8 || n > 1024)
    throw base::InputError("n = " + std::to_string(n) + " is not allowed for doublebubble; n has to be 8 to 1024");
  return double_bubble(n);
}

SurfaceMesh build_foam_start(const base::OptionSet& options) {
  return lostopos::sphere_meshes(
      lostopos::sphere_layout({.spheres = options.whole("spheres"),
                               .layout = lostopos::sphere_layout_by_name(options.word("layout")),
                               .seed = static_cast<std::uint64_t>(options.whole("seed"))}));
}

void let_approach(const base::OptionSet& options, Simulation& simulation) {
  approach(simulation.mesh(), options.number("gap"), options.number("speed"), simulation.circulation());
}

// The vertex has to start inside its frame.
SurfaceMesh build_quad_junction(const base::OptionSet& options) {
  const double displacement = options.number("displacement");
  if (!(std::abs(displacement) < 1.0 / 3))
    throw base::InputError("displacement = " + base::to_text(displacement) +
                           " is not allowed for quadjunction; it has to lie between -1/3 and 1/3");
  return quad_junction_frame(subdivisions(options), displacement);
}

const std::vector<std::string> damped{"surface_tension", "damping", "diffusion"};

}  // namespace

const std::vector<SceneEntry>& scene_entries() {
  static const std::vector<SceneEntry> entries{
      {"sphere",
       "one bubble: a sphere, or one of its oscillation modes",
       {{"n", 3L}, {"topology.enabled", false}},
       "n: subdivisions of an icosahedron (20*4^n triangles); mode, amplitude: start in that mode",
       build_sphere},
      {"tet",
       "one bubble that starts as a tetrahedron and oscillates",
       {{"n", 2L}, {"topology.enabled", false}},
       "n: subdivisions of its flat faces (4*4^n triangles); its sharp corners are unstable for n > 2",
       [](const base::OptionSet& o) { return tetrahedron(subdivisions(o)); }},
      {"cube",
       "one bubble that starts as a cube and oscillates",
       {{"n", 3L}, {"topology.enabled", false}},
       "n: subdivisions of its flat faces (12*4^n triangles)",
       [](const base::OptionSet& o) { return cube(subdivisions(o)); }},
      {"doublebubble",
       "two bubbles that share a wall: the report's case",
       {{"n", 16L}, {"topology.enabled", false}},
       "n: rings and segments of each bubble, 8 or more (880 triangles for 16)",
       build_double_bubble},
      {"twobubbles",
       "two bubbles of radius 1 that fly towards each other, meet, and share a wall",
       {{"n", 3L}},
       "n: subdivisions of each icosahedron (20*4^n triangles); gap, speed: where they start, and how fast",
       [](const base::OptionSet& o) { return two_bubbles(subdivisions(o), o.number("gap")); },
       let_approach},
      {"foaminit",
       "spheres that grow until they have pressed each other into a foam; its last frame is a start mesh",
       {{"time", 0.8}, {"effects", std::vector<std::string>{"growth"}}},
       "spheres, layout, seed: how many and where (320 triangles each)",
       build_foam_start},
      {"triplejunction",
       "three films in a frame whose Plateau border starts bowed and comes to rest straight, at 120 degrees",
       {{"n", 3L}, {"time", 3.0}, {"effects", damped}, {"damping", 0.1}},
       "n: subdivisions of the films (12*4^n triangles); displacement: of the border's middle at the start",
       [](const base::OptionSet& o) { return triple_junction_frame(subdivisions(o), o.number("displacement")); }},
      {"quadjunction",
       "six films in a tetrahedral frame whose Plateau vertex starts off the middle and finds 109.47 degrees",
       {{"n", 4L}, {"time", 3.0}, {"effects", damped}, {"damping", 0.1}},
       "n: subdivisions of the films (6*4^n triangles); displacement: of the vertex at the start",
       build_quad_junction},
  };
  return entries;
}

const SceneEntry& scene_by_name(std::string_view name) {
  return base::find_by_name(scene_entries(), name, "scene");
}

}  // namespace foamsim
