// What effects do to the films and the air of the conservative dynamics from outside.

#include "FoamSim/dynamics/conservative.h"

namespace foamsim {

using lostopos::Region;

AirState Conservative::air(const EffectStep& step, CirculationField& circulation) {
  gather(step, circulation);
  shape_.update(films_, step.mesh.positions());
  change_->evaluate(films_, shape_, step.mesh.positions(), phi_, PairTerms::potential);
  const Invariants now = impulses(films_, shape_, step.mesh.positions(), about_, phi_);
  return {change_->kinetic_energy(), now.impulse, now.angular_impulse};
}

void Conservative::before_burst(const EffectStep& step, CirculationField& circulation, Region region) {
  gather(step, circulation);
  shape_.update(films_, step.mesh.positions());
  burst_.emplace(films_, shape_, phi_, region);
  potential_->scatter(films_, phi_);
}

void Conservative::after_burst(const EffectStep& step, CirculationField& circulation) {
  films_.update(step.mesh, step.geometry, step.held, step.solid);
  shape_.update(films_, step.mesh.positions());
  phi_.resize(films_.entries());
  potential_->gather(films_, phi_);
  burst_->finish(films_, shape_, phi_);
  burst_.reset();
  potential_->scatter(films_, phi_);
  put_circulation(films_, phi_, circulation);
}

void Conservative::surface_changed(const AirState& before, const AirState& after, double films_energy) {
  if (!kept_) return;
  const double air_energy = after.kinetic_energy - before.kinetic_energy;
  expected_kinetic_ += air_energy;
  surface_energy_ += films_energy;
  kept_->energy += air_energy + films_energy;
  kept_->impulse += after.impulse - before.impulse;
  kept_->angular_impulse += after.angular_impulse - before.angular_impulse;
}

void Conservative::drive(StepScope& scope) {
  blown_ = phi_;
  scope.drive_circulation();
  take_circulation(films_, scope.circulation(), phi_);
  put_circulation(films_, phi_, scope.circulation());
  for (std::size_t e = 0; e < blown_.size(); ++e) blown_[e] = phi_[e] - blown_[e];
}

// K is quadratic in φ and f = −½ ∂K/∂φ: K(φ) − K(φ − Δ) = −Δ·(2 f(φ) − f(Δ)).
void Conservative::count_drive(StepScope& scope) {
  change_->evaluate(films_, shape_, scope.positions(), blown_, PairTerms::potential);
  double work = 0;
  for (std::size_t e = 0; e < blown_.size(); ++e) work -= blown_[e] * (2 * motion_->flux()[e] - change_->flux()[e]);
  scope.report().effect_work += work;
  if (!kept_) return;
  expected_kinetic_ += work;
  kept_->energy += work;
}

// The fluxes of a closed region sum up to nothing: what the vertices that move lack goes through those that do not.
void Conservative::let_in(StepScope& scope, double dt, std::span<const double> flux) const {
  if (scope.step().mouth.empty()) return;
  for (std::size_t v = 0; v < films_.vertex_slots(); ++v) {
    if (!scope.step().is_mouth(lostopos::Vertex(v))) continue;
    for (std::size_t e = films_.first_entry[v]; e < films_.first_entry[v + 1]; ++e)
      scope.let_in(films_.regions[e], -dt * flux[e]);
  }
}

}  // namespace foamsim
