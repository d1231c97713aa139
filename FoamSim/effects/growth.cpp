#include "FoamSim/effects/growth.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "LosTopos/mesh/air_side.h"

namespace foamsim {

using lostopos::Vec3;
using lostopos::Vertex;

void Growth::move_vertices(const EffectStep& step, std::span<Vec3> predicted) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, step.mesh.vertex_slots(), 256),
                    [&](const tbb::blocked_range<std::size_t>& range) {
                      for (std::size_t i = range.begin(); i != range.end(); ++i)
                        if (const Vertex v(i); step.mesh.alive(v))
                          predicted[i] += rate_ * step.dt * lostopos::air_side_normal(step.mesh, v);
                    });
}

}  // namespace foamsim
