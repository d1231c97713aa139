#include "FoamSim/effects/growth.h"

#include "LosTopos/mesh/air_side.h"
#include "LosTopos/mesh/for_each_living.h"

namespace foamsim {

using lostopos::Vec3;
using lostopos::Vertex;

void Growth::add_velocity(const Stage& stage, std::span<Vec3> velocity) {
  const lostopos::SurfaceMesh& mesh = stage.step.mesh;
  lostopos::for_each_vertex(
      mesh, [&](Vertex v) { velocity[v.index()] += rate_ * lostopos::air_side_normal(mesh, v, stage.positions); });
}

}  // namespace foamsim
