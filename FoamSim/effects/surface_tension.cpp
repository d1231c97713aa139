#include "FoamSim/effects/surface_tension.h"

#include "FoamSim/sheet/area_gradient.h"
#include "LosTopos/mesh/for_each_living.h"

namespace foamsim {

using lostopos::Vertex;

void SurfaceTension::update_circulation(const EffectStep& step, CirculationField& circulation) {
  if (scheme_ == nullptr) return;
  scheme_->evaluate({step.mesh, step.geometry, circulation, sigma_}, pressures_);
  lostopos::for_each_vertex(step.mesh, [&](Vertex v) {
    if (step.is_held(v)) return;
    for (PairCirculation& entry : circulation.at(v))
      entry.value +=
          pressures_.coefficient * step.dt *
          (pressures_.at(step.geometry, v, entry.pair.low) - pressures_.at(step.geometry, v, entry.pair.high));
  });
}

double SurfaceTension::potential_energy(const Stage& stage) const {
  return 4 * sigma_ * film_area(stage.step.mesh, stage.step.solid, stage.positions);
}

void SurfaceTension::add_force(const Stage& stage, std::span<lostopos::Vec3> force) {
  if (scheme_ != nullptr) return;
  add_area_gradient(stage.step.mesh, stage.step.solid, stage.positions, 4 * sigma_, force);
}

}  // namespace foamsim
