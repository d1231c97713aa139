#include "FoamSim/effects/damping.h"

#include <cmath>

namespace foamsim {

void Damping::update_circulation(const EffectStep& step, CirculationField& circulation) {
  if (step.time < from_) return;
  const double factor = std::pow(factor_, step.dt);
  for (lostopos::Vertex v : step.mesh.vertices())
    for (PairCirculation& held : circulation.at(v)) held.value *= factor;
}

}  // namespace foamsim
