#include "FoamSim/effects/surface_tension.h"

#include "LosTopos/mesh/for_each_living.h"

namespace foamsim {

using lostopos::Vertex;

void SurfaceTension::update_circulation(const EffectStep& step, CirculationField& circulation) {
  scheme_->evaluate({step.mesh, step.geometry, circulation, sigma_}, pressures_);
  lostopos::for_each_vertex(step.mesh, [&](Vertex v) {
    if (step.is_held(v)) return;
    for (PairCirculation& entry : circulation.at(v))
      entry.value +=
          pressures_.coefficient * step.dt *
          (pressures_.at(step.geometry, v, entry.pair.low) - pressures_.at(step.geometry, v, entry.pair.high));
  });
}

}  // namespace foamsim
