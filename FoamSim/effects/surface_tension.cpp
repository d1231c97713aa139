#include "FoamSim/effects/surface_tension.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>

namespace foamsim {

using lostopos::Vertex;

void SurfaceTension::update_circulation(const EffectStep& step, CirculationField& circulation) {
  curvature_.update(step.mesh, step.geometry, *scheme_);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, step.mesh.vertex_slots(), 256),
                    [&](const tbb::blocked_range<std::size_t>& range) {
                      for (std::size_t i = range.begin(); i != range.end(); ++i) {
                        const Vertex v(i);
                        if (!step.mesh.alive(v) || step.is_held(v)) continue;
                        for (PairCirculation& entry : circulation.at(v))
                          entry.value += sigma_ * step.dt *
                                         (curvature_.get(step.geometry, v, entry.pair.low) -
                                          curvature_.get(step.geometry, v, entry.pair.high));
                      }
                    });
}

}  // namespace foamsim
