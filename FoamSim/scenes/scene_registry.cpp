#include "FoamSim/scenes/scene_registry.h"

#include "FoamSim/names/nearest_name.h"
#include "FoamSim/scenes/shapes/double_bubble.h"
#include "FoamSim/scenes/shapes/solids.h"
#include "LosTopos/error.h"

namespace foamsim {

using lostopos::SurfaceMesh;

namespace {

// Beyond eight subdivisions (over a million triangles) direct summation would not end in a lifetime of patience.
long subdivisions(const OptionSet& options) {
  const long n = options.whole("n");
  if (n > 8)
    throw lostopos::InputError("n = " + std::to_string(n) + " subdivisions are too many here; n has to be 0 to 8");
  return n;
}

SurfaceMesh build_sphere(const OptionSet& options) {
  SurfaceMesh mesh = icosphere(subdivisions(options));
  if (const long mode = options.whole("mode"); mode > 0) perturb_with_mode(mesh, mode, options.number("amplitude"));
  return mesh;
}

SurfaceMesh build_double_bubble(const OptionSet& options) {
  const long n = options.whole("n");
  if (n < 8 || n > 1024)
    throw lostopos::InputError("n = " + std::to_string(n) + " is not allowed for doublebubble; n has to be 8 to 1024");
  return double_bubble(n);
}

}  // namespace

const std::vector<SceneEntry>& scene_entries() {
  static const std::vector<SceneEntry> entries{
      {"sphere",
       "one bubble: a sphere, or one of its oscillation modes",
       {{"n", 3L}},
       "n: subdivisions of an icosahedron (20*4^n triangles); mode, amplitude: start in that mode",
       build_sphere},
      {"tet",
       "one bubble that starts as a tetrahedron and oscillates",
       {{"n", 4L}},
       "n: subdivisions of its flat faces (4*4^n triangles)",
       [](const OptionSet& o) { return tetrahedron(subdivisions(o)); }},
      {"cube",
       "one bubble that starts as a cube and oscillates",
       {{"n", 3L}},
       "n: subdivisions of its flat faces (12*4^n triangles)",
       [](const OptionSet& o) { return cube(subdivisions(o)); }},
      {"doublebubble",
       "two bubbles that share a wall: the report's case",
       {{"n", 16L}},
       "n: rings and segments of each bubble, 8 or more (880 triangles for 16)",
       build_double_bubble},
  };
  return entries;
}

const SceneEntry& scene_by_name(std::string_view name) {
  return find_by_name(scene_entries(), name, "scene");
}

}  // namespace foamsim
