#include "FoamSim/effects/growth.h"

#include "LosTopos/mesh/air_side.h"
#include "LosTopos/mesh/for_each_living.h"

namespace foamsim {

using lostopos::Vec3;
using lostopos::Vertex;

namespace {

// Mean of the unit normals into the air of v's triangles that touch it; zero where none do.
Vec3 mean_unit_normal(const EffectStep& step, Vertex v) {
  Vec3 sum = Vec3::Zero();
  int count = 0;
  for (lostopos::Triangle t : step.mesh.triangles(v)) {
    const lostopos::Labels labels = step.mesh.labels(t);
    if (!labels.has(lostopos::air)) continue;
    // The right-hand normal points from p into q.
    sum += labels.q == lostopos::air ? step.geometry.unit_normal(t) : Vec3(-step.geometry.unit_normal(t));
    ++count;
  }
  return count == 0 ? sum : Vec3(sum / count);
}

}  // namespace

std::vector<Vec3> Growth::displaced(const EffectStep& step) {
  if (normals_ != GrowthNormals::unit || rate_ == 0) return {};
  std::vector<Vec3> positions(step.mesh.positions().begin(), step.mesh.positions().end());
  lostopos::for_each_vertex(step.mesh, [&](Vertex v) {
    if (!step.is_held(v)) positions[v.index()] += rate_ * step.dt * mean_unit_normal(step, v);
  });
  return positions;
}

void Growth::add_velocity(const Stage& stage, std::span<Vec3> velocity) {
  if (normals_ != GrowthNormals::area_weighted) return;
  const lostopos::SurfaceMesh& mesh = stage.step.mesh;
  lostopos::for_each_vertex(
      mesh, [&](Vertex v) { velocity[v.index()] += rate_ * lostopos::air_side_normal(mesh, v, stage.positions); });
}

}  // namespace foamsim
