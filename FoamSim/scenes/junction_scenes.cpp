#include "FoamSim/scenes/scene_families.h"
#include "FoamSim/scenes/scene_sizes.h"
#include "FoamSim/scenes/shapes/free_junctions.h"
#include "FoamSim/scenes/shapes/junction_frames.h"
#include "FoamSim/scenes/shapes/wands.h"

namespace foamsim {

using base::OptionSet;

namespace {

using base::Words;

const Words damped{"surface_tension", "damping", "diffusion"};

// The reference program's: nothing held, the mesh as it is.
std::vector<std::pair<std::string, base::OptionValue>> left_alone(double diffusion) {
  return {{"time", 1.0},
          {"constraints", Words{}},
          {"diffusion", diffusion},
          {"remeshing.enabled", false},
          {"topology.enabled", false}};
}

SceneEntry barrel_scene() {
  return {"barrel",
          "an open cylinder of film, nothing held: it stands still",
          {whole_between(3, 4096, 24, "n", "vertices of each ring"),
           whole_between(2, 4096, 10, "m", "rings from end to end")},
          left_alone(0),
          [](const OptionSet& options) { return barrel(options.whole("n"), options.whole("m")); }};
}

SceneEntry triple_junction_scene() {
  return {"triplejunction",
          "three flat films that meet at 120 degrees, nothing held: they stand still",
          {subdivisions(2, "subdivisions of the films (6*4^n triangles)")},
          left_alone(0),
          [](const OptionSet& options) { return free_triple_junction(options.whole("n")); }};
}

SceneEntry triple_junction_frame_scene() {
  return {"triplejunction-frame",
          "three films in a frame whose Plateau border starts bowed and comes to rest straight, at 120 degrees",
          {subdivisions(3, "subdivisions of the films (12*4^n triangles)"),
           number_below(1, "1", "displacement", 0.2, "of the border's middle at the start, L")},
          {{"time", 3.0}, {"effects", damped}, {"damping", 0.1}},
          [](const OptionSet& options) {
            return triple_junction_frame(options.whole("n"), options.number("displacement"));
          }};
}

SceneEntry quad_junction_scene() {
  return {"quadjunction",
          "six flat films round a Plateau vertex off its balance, nothing held: it moves towards it",
          {subdivisions(2, "subdivisions of the films (12*4^n triangles)")},
          left_alone(2),
          [](const OptionSet& options) { return free_quad_junction(options.whole("n")); }};
}

SceneEntry quad_junction_frame_scene() {
  return {
      "quadjunction-frame",
      "six films in a tetrahedral frame whose Plateau vertex starts off the middle and finds 109.47 degrees",
      {subdivisions(4, "subdivisions of the films (6*4^n triangles)"),
       // The vertex has to start inside its frame.
       number_below(1.0 / 3, "1/3", "displacement", 0.2, "of the vertex at the start, L")},
      {{"time", 3.0}, {"effects", damped}, {"damping", 0.1}},
      [](const OptionSet& options) { return quad_junction_frame(options.whole("n"), options.number("displacement")); }};
}

}  // namespace

std::vector<SceneEntry> junction_scenes() {
  return {sized(barrel_scene(), triangles_of_rings(1)), sized(triple_junction_scene(), triangles_of_subdivided(6)),
          sized(triple_junction_frame_scene(), triangles_of_subdivided(12)),
          sized(quad_junction_scene(), triangles_of_subdivided(12)),
          sized(quad_junction_frame_scene(), triangles_of_subdivided(6))};
}

}  // namespace foamsim
