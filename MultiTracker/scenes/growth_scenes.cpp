#include <algorithm>

#include "LosTopos/mesh/box_walls.h"
#include "LosTopos/mesh/measures.h"
#include "LosTopos/shapes/sphere_layout.h"
#include "MultiTracker/flows/face_offset.h"
#include "MultiTracker/flows/normal_flow.h"
#include "MultiTracker/scenes/scene_lists.h"
#include "MultiTracker/scenes/shapes/film_boxes.h"

namespace multitracker {

using lostopos::Region;
using lostopos::SurfaceMesh;
using lostopos::Vec3;

namespace {

base::OptionSpec layout() {
  return {"layout", std::string("grid"), "of the spheres: jittered on a grid, or anywhere", "grid or random",
          [](const base::OptionValue& value) {
            const auto& word = std::get<std::string>(value);
            return word == "grid" || word == "random";
          }};
}

base::OptionSpec spheres_option() {
  return base::whole_between(1, 1'000'000, 8, "spheres", "number of spheres, of 320 triangles each");
}

double triangles_of_spheres(const base::OptionSet& options) {
  return 320 * static_cast<double>(options.whole("spheres"));
}

std::vector<lostopos::Sphere> spheres(const base::OptionSet& options) {
  return lostopos::sphere_layout({.spheres = options.whole("spheres"),
                                  .layout = lostopos::sphere_layout_by_name(options.word("layout")),
                                  .seed = static_cast<std::uint64_t>(options.whole("seed"))});
}

Drive growth(const base::OptionSet& options, const SurfaceMesh&) {
  return {std::make_unique<FaceOffsetFlow>(PairSpeeds(options.number("speed"))), options.number("dt")};
}

SceneEntry normal_flow() {
  return {"normal-flow",
          "spheres that grow along their normals until they press into a foam",
          {spheres_option(), layout(), base::flag("one_region", false, "all spheres are one region and flow together"),
           base::positive_number("step", 0.05, "way along the normal a step, in mean edges of the start surface")},
          // Films that are pressed together meet before they crumple: the distance of docs/method.md, not that of plain
          // tracking.
          {{"steps", 60L}, {"topology.merge_distance", 0.1}},
          [](const base::OptionSet& options) {
            return lostopos::sphere_meshes(spheres(options), options.flag("one_region"));
          },
          // At unit speed: time is the way.
          [](const base::OptionSet& options, const SurfaceMesh& start) -> Drive {
            return {std::make_unique<NormalFlow>(1), options.number("step") * lostopos::mean_edge_length(start)};
          }};
}

SceneEntry merge() {
  return {"merge",
          "spheres of one region that grow into each other",
          {spheres_option(), layout(), base::positive_number("speed", 1, "of growth along the normal"),
           base::positive_number("dt", 0.005, "time step")},
          {{"steps", 60L}},
          [](const base::OptionSet& options) { return lostopos::sphere_meshes(spheres(options), true); },
          growth};
}

SceneEntry coalescence() {
  return {"coalescence",
          "two spheres of one region that touch and become one",
          {base::positive_number("gap", 0.05, "between the two spheres of radius 0.5 at the start"),
           base::positive_number("speed", 1, "of growth along the normal"),
           base::positive_number("dt", 0.002, "time step")},
          {{"steps", 40L}},
          [](const base::OptionSet& options) {
            const Vec3 off(0.5 + options.number("gap") / 2, 0, 0);
            return lostopos::sphere_meshes({{off, 0.5}, {-off, 0.5}}, true);
          },
          growth};
}

SceneEntry cyclic_flow() {
  return {"cyclicflow",
          "three regions that chase each other in a box",
          {subdivisions(2),
           base::whole_between(1, 1000, 2, "layers", "rows of films along the line in which the regions meet"),
           base::positive_number("speed_12", 1, "at which region 1 grows into 2"),
           base::positive_number("speed_23", 1, "at which region 2 grows into 3"),
           base::positive_number("speed_31", 1, "at which region 3 grows into 1"),
           base::positive_number("dt", 0.01, "time step")},
          {{"steps", 60L}},
          [](const base::OptionSet& options) {
            return three_cells(options.whole("layers"), options.whole("subdivisions"));
          },
          [](const base::OptionSet& options, const SurfaceMesh& start) -> Drive {
            // A file may count its three regions from 0.
            const bool from_zero = !std::ranges::binary_search(lostopos::regions(start), Region(3));
            const Region third(from_zero ? 0 : 3);
            PairSpeeds speeds;
            speeds.set(Region(1), Region(2), options.number("speed_12"));
            speeds.set(Region(2), third, options.number("speed_23"));
            speeds.set(third, Region(1), options.number("speed_31"));
            return {std::make_unique<FaceOffsetFlow>(std::move(speeds)), options.number("dt")};
          },
          [](const base::OptionSet&, lostopos::SurfaceTracker& tracker) {
            hold_in_box_walls(tracker.mesh(), tracker.held(), Vec3::Zero(), Vec3::Ones());
          }};
}

}  // namespace

std::vector<SceneEntry> growth_scenes() {
  return {sized(normal_flow(), triangles_of_spheres), sized(merge(), triangles_of_spheres), coalescence(),
          sized(cyclic_flow(), [](const base::OptionSet& options) {
            return subdivided(53 * static_cast<double>(options.whole("layers")), options);
          })};
}

}  // namespace multitracker
