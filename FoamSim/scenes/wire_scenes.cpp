#include "FoamSim/scenes/scene_families.h"
#include "FoamSim/scenes/scene_sizes.h"
#include "FoamSim/scenes/shapes/held_bubbles.h"
#include "FoamSim/scenes/shapes/hexagon_sheet.h"
#include "FoamSim/scenes/shapes/octahedron_frame.h"
#include "FoamSim/scenes/shapes/wands.h"

namespace foamsim {

using base::OptionSet;

namespace {

using Defaults = std::vector<std::pair<std::string, base::OptionValue>>;
using base::Words;

// Films held by wires that move so (see WireSpec), with what else the scene sets. The reference program's clock runs
// twice as fast: its speeds are doubled here, its times halved.
Defaults wired(Words wires, Defaults more) {
  more.emplace_back("constraints", Words{"wire"});
  more.emplace_back("wires", std::move(wires));
  return more;
}

base::OptionSpec rings_of_bubbles() {
  return whole_between(6, 512, 24, "n", "rings of each bubble from pole to pole");
}

base::OptionSpec segments_of_bubbles() {
  return whole_between(3, 1024, 30, "m", "vertices of each ring");
}

base::OptionSpec segments_of_rings(long default_value) {
  return whole_between(3, 4096, default_value, "n", "vertices of each ring");
}

SceneEntry constrained_sphere_scene() {
  return {"constrainedsphere",
          "an ellipsoid (0.6, 1, 1) held by a ring round its pole: the rest becomes round",
          {subdivisions(3, "subdivisions of an icosahedron (20*4^n triangles)", 2)},
          wired({"held: still"}, {{"time", 1.0}, {"diffusion", 20.0}}),
          [](const OptionSet& options) { return held_ellipsoid(options.whole("n")); }};
}

SceneEntry bubble_wand_scene() {
  return {"bubblewand",
          "a ring with a film across it, dragged sideways: the film stays behind and becomes a bubble",
          {segments_of_rings(12)},
          wired({"held: move -2 0 0"}, {{"time", 1.0}, {"sigma", 0.2}, {"diffusion", 2.0}, {"resolution", 0.25}}),
          [](const OptionSet& options) { return wand(options.whole("n")); }};
}

SceneEntry two_rings_scene() {
  return {"tworingspinching",
          "a film between two rings that are pulled apart: a catenoid, until it pinches",
          {segments_of_rings(24)},
          wired({"held and x < 0: move -0.08 0 0 until 2.5", "held and x > 0: move 0.08 0 0 until 2.5"},
                {{"time", 3.0}, {"diffusion", 16.0}, {"resolution", 0.15}}),
          [](const OptionSet& options) { return two_rings(options.whole("n")); }};
}

SceneEntry peanut_scene() {
  return {"peanutbubble",
          "a bubble held at its waist by a ring: two halves of almost the same size, which is unstable",
          {rings_of_bubbles(), segments_of_bubbles()},
          wired({"held: still"}, {{"time", 8.0}, {"diffusion", 20.0}, {"resolution", 0.1}}),
          [](const OptionSet& options) { return peanut(options.whole("n"), options.whole("m")); }};
}

const std::vector<std::string> blown{"surface_tension", "diffusion", "blow"};

SceneEntry straw_scene() {
  return {"straw",
          "a bubble blown through a straw",
          {segments_of_rings(24)},
          wired({"held: still"}, {{"time", 1.0}, {"effects", blown}, {"diffusion", 20.0}, {"resolution", 0.25}}),
          [](const OptionSet& options) { return wand(options.whole("n")); }};
}

SceneEntry carousel_scene() {
  return {"carousel",
          "a third bubble blown through a straw below two that are held, until it meets them",
          {rings_of_bubbles(), segments_of_bubbles()},
          wired({"held and y < -4: move 0 -0.4 0 from 5"}, {{"time", 6.0},
                                                            {"effects", blown},
                                                            {"diffusion", 20.0},
                                                            {"resolution", 0.4},
                                                            {"blow_region", 3L},
                                                            {"blow_until", 5.0},
                                                            {"blow_where", std::string("held and y < -4")}}),
          [](const OptionSet& options) { return carousel(options.whole("n"), options.whole("m")); }};
}

SceneEntry sheet_scene() {
  return {"sheet",
          "a film in an elastic closed wire that hangs from one point",
          {subdivisions(2, "subdivisions of the hexagon (6*4^n triangles)", 1)},
          {{"time", 1.0},
           {"dt", 0.001},
           {"diffusion", 2.0},
           {"resolution", 0.25},
           {"constraints", Words{"rod"}},
           {"rod_radius", 0.003},
           {"stretching", 5000.0},
           {"bending", 150.0},
           {"gravity", 9.8},
           {"reference_units", true},
           {"rod_fixed", std::string("held and z > 0.86 and x > -0.01 and x < 0.01")}},
          [](const OptionSet& options) { return hexagon_sheet(options.whole("n")); }};
}

SceneEntry octahedron_scene() {
  return {"octahedron",
          "films in the frame of an octahedron, eight regions that meet at one point near its middle",
          {},
          wired({"held: still"}, {{"time", 2.0}, {"diffusion", 10.0}, {"resolution", 0.2}}),
          [](const OptionSet& options) { return octahedron_frame(static_cast<std::uint64_t>(options.whole("seed"))); }};
}

}  // namespace

std::vector<SceneEntry> wire_scenes() {
  return {sized(constrained_sphere_scene(), triangles_of_subdivided(20)),
          bubble_wand_scene(),
          two_rings_scene(),
          sized(peanut_scene(), triangles_of_rings(1.5)),
          straw_scene(),
          sized(carousel_scene(), triangles_of_rings(1.5)),
          sized(sheet_scene(), triangles_of_subdivided(6)),
          octahedron_scene()};
}

}  // namespace foamsim
