#include "MultiTracker/scenes/scene.h"

#include "LosTopos/names/nearest_name.h"
#include "LosTopos/shapes/solids.h"
#include "MultiTracker/flows/enright.h"
#include "MultiTracker/flows/rotation.h"

namespace multitracker {

using lostopos::SurfaceMesh;
using lostopos::Vec3;

namespace {

SurfaceMesh sphere_at(const Vec3& centre, double radius, long subdivisions) {
  SurfaceMesh mesh = lostopos::icosphere(subdivisions, radius);
  for (lostopos::Vertex v : mesh.vertices()) mesh.set_position(v, mesh.position(v) + centre);
  return mesh;
}

}  // namespace

const std::vector<SceneEntry>& scene_entries() {
  static const std::vector<SceneEntry> entries{
      {"enright", "a sphere drawn out into a thin sheet and back (LeVeque 1996, Enright et al. 2002)",
       [](long n) {
         return sphere_at({0.35, 0.35, 0.35}, 0.15, n);
       },
       []() -> std::unique_ptr<Flow> { return std::make_unique<EnrightFlow>(); }},
      {"rotation", "a sphere carried once around an axis (after Zalesak 1979)",
       [](long n) {
         return sphere_at({0.5, 0.75, 0.5}, 0.15, n);
       },
       []() -> std::unique_ptr<Flow> { return std::make_unique<RotationFlow>(Vec3(0.5, 0.5, 0.5)); }},
  };
  return entries;
}

const SceneEntry& scene_by_name(std::string_view name) {
  return lostopos::find_by_name(scene_entries(), name, "scene");
}

}  // namespace multitracker
