#include <cmath>

#include "LosTopos/shapes/solids.h"
#include "MultiTracker/flows/alternating_flow.h"
#include "MultiTracker/flows/curl_noise.h"
#include "MultiTracker/flows/enright.h"
#include "MultiTracker/flows/face_offset.h"
#include "MultiTracker/flows/prescribed_flow.h"
#include "MultiTracker/flows/rotation.h"
#include "MultiTracker/scenes/scene_lists.h"
#include "MultiTracker/scenes/shapes/slotted_disc.h"

namespace multitracker {

using lostopos::SurfaceMesh;
using lostopos::Vec3;

namespace {

const Vec3 box_centre(0.5, 0.5, 0.5);
const Vec3 off_centre(0.5, 0.75, 0.5);

double triangles_of_sphere(const base::OptionSet& options) {
  return subdivided(20, options);
}

SurfaceMesh sphere_at(const Vec3& centre, double radius, const base::OptionSet& options) {
  SurfaceMesh mesh = lostopos::icosphere(options.whole("subdivisions"), radius);
  for (lostopos::Vertex v : mesh.vertices()) mesh.set_position(v, mesh.position(v) + centre);
  return mesh;
}

// One period of a velocity field in the number of steps there are.
Drive one_period(std::unique_ptr<Flow> flow, const base::OptionSet& options) {
  const double dt = flow->period() / static_cast<double>(std::max(1L, options.whole("period_steps")));
  return {std::make_unique<PrescribedFlow>(std::move(flow)), dt};
}

base::OptionSpec period_steps(long count) {
  return base::whole_number("period_steps", count, 1, "steps in one period of the flow");
}

Drive turn(const base::OptionSet& options, const SurfaceMesh&) {
  return one_period(std::make_unique<RotationFlow>(box_centre), options);
}

SceneEntry enright() {
  return {"enright",
          "a sphere drawn out into a thin sheet and back (LeVeque 1996, Enright et al. 2002)",
          {subdivisions(3), period_steps(300)},
          {{"steps", 300L}},
          [](const base::OptionSet& options) {
            return sphere_at({0.35, 0.35, 0.35}, 0.15, options);
          },
          [](const base::OptionSet& options, const SurfaceMesh&) {
            return one_period(std::make_unique<EnrightFlow>(), options);
          }};
}

SceneEntry rotation() {
  return {"rotation",
          "a sphere carried once around an axis",
          {subdivisions(3), period_steps(200)},
          {{"steps", 200L}},
          [](const base::OptionSet& options) { return sphere_at(off_centre, 0.15, options); },
          turn};
}

SceneEntry zalesak() {
  return {"zalesak",
          "a slotted disc carried once around an axis (Zalesak 1979)",
          {subdivisions(1), period_steps(200), base::whole_between(12, 4096, 32, "segments", "of the disc's rim")},
          {{"steps", 200L}},
          [](const base::OptionSet& options) {
            return slotted_disc({.centre = off_centre,
                                 .segments = options.whole("segments"),
                                 .subdivisions = options.whole("subdivisions")});
          },
          turn};
}

SceneEntry noise() {
  return {"noise",
          "a sphere stirred by random curl noise and growing, in turn",
          {subdivisions(3), base::positive_number("dt", 0.01, "time step"),
           base::positive_number("noise_speed", 0.5, "root mean square speed of the noise"),
           base::positive_number("wavelength", 0.5, "longest in the noise"),
           base::positive_number("growth", 0.1, "speed along the normal"),
           base::positive_number("turn", 0.1, "time after which noise and growth take turns")},
          {},
          [](const base::OptionSet& options) { return sphere_at(box_centre, 0.15, options); },
          [](const base::OptionSet& options, const SurfaceMesh&) -> Drive {
            std::vector<std::unique_ptr<SurfaceFlow>> flows;
            flows.push_back(std::make_unique<PrescribedFlow>(
                std::make_unique<CurlNoiseFlow>(static_cast<std::uint64_t>(options.whole("seed")),
                                                options.number("noise_speed"), options.number("wavelength"))));
            flows.push_back(std::make_unique<FaceOffsetFlow>(PairSpeeds(options.number("growth"))));
            return {std::make_unique<AlternatingFlow>(std::move(flows), options.number("turn")), options.number("dt")};
          }};
}

}  // namespace

std::vector<SceneEntry> prescribed_scenes() {
  return {sized(enright(), triangles_of_sphere), sized(rotation(), triangles_of_sphere),
          sized(zalesak(),
                [](const base::OptionSet& options) {
                  const auto segments = static_cast<double>(options.whole("segments"));
                  return subdivided(0.5 * segments * segments, options);
                }),
          sized(noise(), triangles_of_sphere)};
}

}  // namespace multitracker
