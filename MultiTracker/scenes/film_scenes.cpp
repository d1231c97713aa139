#include <cmath>

#include "LosTopos/shapes/voronoi_foam.h"
#include "MultiTracker/flows/area_gradient.h"
#include "MultiTracker/flows/mean_curvature.h"
#include "MultiTracker/flows/pulled_apart.h"
#include "MultiTracker/scenes/scene_lists.h"
#include "MultiTracker/scenes/shapes/film_boxes.h"

namespace multitracker {

using lostopos::SurfaceMesh;
using lostopos::SurfaceTracker;
using lostopos::Vec3;

namespace {

constexpr double box_width = 1.2, box_height = 0.6, box_depth = 0.6;
constexpr double ring_radius = 0.5;

base::OptionSpec time_step(double dt) {
  return base::positive_number("dt", dt, "time step");
}

// Films under tension: the usual bounds, and films part when that shrinks the area.
std::vector<SceneEntry::Default> under_tension(long steps) {
  return {{"steps", steps},
          {"remeshing.max_volume_change", 1e-2},
          {"topology.merge_distance", 0.1},
          {"topology.separation", std::string("area")}};
}

constexpr const char* by_curvature = "curvature";
constexpr const char* by_area_gradient = "area-gradient";

std::vector<SceneEntry::Default> and_more(std::vector<SceneEntry::Default> defaults,
                                          const std::vector<SceneEntry::Default>& more) {
  defaults.insert(defaults.end(), more.begin(), more.end());
  return defaults;
}

base::OptionSpec flow() {
  return base::word_from("flow", std::string(by_curvature),
                         "what moves films: mean curvature, or the gradient of the area (not over a vertex' area)",
                         "flow", {by_curvature, by_area_gradient});
}

std::unique_ptr<SurfaceFlow> tension_of(const base::OptionSet& options) {
  if (options.word("flow") == by_area_gradient) return std::make_unique<AreaGradientFlow>();
  return std::make_unique<MeanCurvatureFlow>();
}

Drive under_tension_flow(const base::OptionSet& options, const SurfaceMesh&) {
  return {tension_of(options), options.number("dt")};
}

void hold_air_side(const base::OptionSet&, SurfaceTracker& tracker) {
  for (lostopos::Triangle t : tracker.mesh().triangles())
    if (tracker.mesh().labels(t).has(lostopos::air))
      for (lostopos::Vertex v : tracker.mesh().vertices(t)) tracker.held()[v] = lostopos::Hold::all;
}

SceneEntry t1() {
  return {"T1",
          "two junction lines come together and part the other way",
          {subdivisions(2), time_step(0.002), flow(),
           base::whole_between(1, 1000, 2, "layers", "rows of films along the lines"),
           base::non_negative_number("gap", 0.12, "between the two lines; 0: four films meet in one line")},
          under_tension(60),
          [](const base::OptionSet& options) {
            if (options.number("gap") > 0.9 * box_height)
              throw base::InputError("gap has to be at most " + std::to_string(0.9 * box_height));
            return four_cells({.size = {box_width, box_height, box_depth},
                               .gap = options.number("gap"),
                               .layers = options.whole("layers"),
                               .subdivisions = options.whole("subdivisions")});
          },
          under_tension_flow,
          nullptr,
          true,
          AtWalls::slide,
          {box_width, box_height, box_depth}};
}

SceneEntry t2() {
  return {
      "T2",
      "a small region among four disappears",
      {subdivisions(3),
       time_step(0.002),
       flow(),
       {"size", 0.1, "of the small region against the whole", "a number in (0, 0.9]",
        [](const base::OptionValue& value) { return std::get<double>(value) > 0 && std::get<double>(value) <= 0.9; }}},
      under_tension(40),
      [](const base::OptionSet& options) {
        return nested_tetrahedra(options.number("size"), options.whole("subdivisions"));
      },
      under_tension_flow,
      hold_air_side,
      true,
      AtWalls::stay};
}

SceneEntry prism() {
  return {"prism",
          "films in a triangular prism: the edge in the middle becomes a face, or the face an edge, as the height asks",
          {subdivisions(3),
           time_step(0.002),
           flow(),
           {"middle", std::string("edge"), "what is in the middle at the start", "edge or face",
            [](const base::OptionValue& value) {
              const auto& word = std::get<std::string>(value);
              return word == "edge" || word == "face";
            }},
           base::positive_number("height", 0.25, "of the prism, whose triangles have sides of 1"),
           base::positive_number("size", 0.12, "of the edge or the face's sides at the start")},
          under_tension(100),
          [](const base::OptionSet& options) {
            const bool edge = options.word("middle") == "edge";
            const double limit = edge ? options.number("height") : 1;
            if (!(options.number("size") < limit))
              throw base::InputError("size has to be less than " + std::to_string(limit));
            return film_prism({.height = options.number("height"),
                               .middle = edge ? PrismMiddle::edge : PrismMiddle::face,
                               .size = options.number("size"),
                               .subdivisions = options.whole("subdivisions")});
          },
          under_tension_flow,
          hold_air_side};
}

SceneEntry mcf() {
  return {"mcf",
          "a random foam in the unit box that coarsens under mean curvature flow; its ends slide along the walls",
          {subdivisions(1), time_step(2e-3), flow(),
           base::flag("faster_later", false, "steps are 4 times as long from time 6 on, and 16 times from time 30 on"),
           base::whole_between(1, 1'000'000, 30, "cells", "bubbles at the start"),
           base::whole_between(0, 1000, 3, "relaxations", "rounds that make the bubbles more alike")},
          // Films that shrink to nothing race: in parts of the usual length a step of a large foam takes half a minute.
          and_more(under_tension(200), {{"topology.longest_motion", 0.5}}),
          [](const base::OptionSet& options) {
            return lostopos::voronoi_foam({.cells = options.whole("cells"),
                                           .seed = static_cast<std::uint64_t>(options.whole("seed")),
                                           .relaxations = static_cast<int>(options.whole("relaxations")),
                                           .subdivisions = options.whole("subdivisions")});
          },
          [](const base::OptionSet& options, const SurfaceMesh&) -> Drive {
            StepLengths dt(options.number("dt"));
            if (options.flag("faster_later")) dt.grow_from(6, 4).grow_from(30, 4);
            return {tension_of(options), std::move(dt)};
          },
          nullptr,
          true,
          AtWalls::slide};
}

SceneEntry catenoid() {
  return {"catenoid",
          "a film between two rings that are pulled apart until it pinches off",
          {time_step(0.005), base::whole_between(8, 4096, 32, "segments", "of each ring"),
           base::positive_number("pull", 0.25, "speed of each ring"),
           base::positive_number("half_length", 0.2, "from the middle to each ring of radius 0.5 at the start")},
          under_tension(160),
          [](const base::OptionSet& options) {
            return open_tube(ring_radius, options.number("half_length"), options.whole("segments"));
          },
          [](const base::OptionSet& options, const SurfaceMesh&) -> Drive {
            return {std::make_unique<PulledApartFlow>(std::make_unique<MeanCurvatureFlow>(), options.number("pull")),
                    options.number("dt")};
          },
          // Everything at the film's free ends, also of a film from a file.
          [](const base::OptionSet&, SurfaceTracker& tracker) {
            for (lostopos::Edge e : tracker.mesh().edges())
              if (tracker.mesh().triangles(e).size() == 1)
                for (lostopos::Vertex v : tracker.mesh().vertices(e)) tracker.held()[v] = lostopos::Hold::all;
          },
          false};
}

}  // namespace

std::vector<SceneEntry> film_scenes() {
  return {sized(t1(),
                [](const base::OptionSet& options) {
                  return subdivided(46 * static_cast<double>(options.whole("layers")), options);
                }),
          sized(t2(), [](const base::OptionSet& options) { return subdivided(32, options); }),
          sized(prism(), [](const base::OptionSet& options) { return subdivided(32, options); }),
          sized(mcf(),
                [](const base::OptionSet& options) {
                  return subdivided(28 * static_cast<double>(options.whole("cells")), options);
                }),
          catenoid()};
}

}  // namespace multitracker
