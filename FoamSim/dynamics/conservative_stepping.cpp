// How the conservative dynamics go from one instant to the next.

#include <algorithm>
#include <cmath>

#include "Base/timing/stopwatch.h"
#include "FoamSim/dynamics/conservative.h"

namespace foamsim {

using lostopos::Vec3;

namespace {

// out = x + h y
template <class T>
void shift(std::span<const T> x, double h, std::span<const T> y, std::vector<T>& out) {
  out.resize(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) out[i] = x[i] + h * y[i];
}

template <class T>
std::span<const T> view(const std::vector<T>& values) {
  return values;
}

}  // namespace

void Conservative::substep(const Substep& step, Positions& x) {
  const base::TimedScope timed(step.scope.report().times, "kick");
  if (options_.stepping == Stepping::kick_drift) return kick_drift(step, x);
  if (step.after == 0) report_state(step.scope, motion_->kinetic_energy(), phi_);
  if (viscosity_->acts()) {
    // Split off: what it does to φ comes first.
    force_.assign(films_.vertex_slots(), Vec3::Zero());
    add_viscosity(step);
    press(rates_.phi);
    for (std::size_t e = 0; e < phi_.size(); ++e) phi_[e] += step.dt * rates_.phi[e];
    evaluate(step.scope, step.after, x, phi_, rates_);
  }
  count_inertia_work(step.scope, step.dt, x);
  if (options_.stepping == Stepping::midpoint)
    midpoint(step, x);
  else
    rk4(step, x);
}

void Conservative::add_viscosity(const Substep& step) {
  const long iterations = viscosity_->add_force(step.response, step.dt, rates_.x, force_);
  long& most = step.scope.report().viscosity_iterations;
  most = std::max(most, iterations);
}

void Conservative::kick_drift(const Substep& step, Positions& x) {
  StepScope& scope = step.scope;
  const double after = step.after, dt = step.dt;
  const bool first = after == 0;
  if (viscosity_->acts()) {
    add_viscosity(step);
    press(rates_.phi);
  }
  shift(view(phi_), dt, view(rates_.phi), new_phi_);
  if (first) correct(scope, new_phi_);
  stage_phi_.resize(phi_.size());
  for (std::size_t e = 0; e < phi_.size(); ++e) stage_phi_[e] = new_phi_[e] - phi_[e];
  change_->evaluate(films_, shape_, x, stage_phi_, PairTerms::potential);
  const double wire_work = drives_air() ? hold_in_kick(scope, x) : 0;
  count_work(scope, wire_work / 2);
  // φ half-way between before and after the kick belongs to the positions.
  std::vector<double> flux(films_.entries());
  double kinetic = 0;
  for (std::size_t e = 0; e < flux.size(); ++e) {
    flux[e] = motion_->flux()[e] + change_->flux()[e];
    stage_phi_[e] = (phi_[e] + new_phi_[e]) / 2;
    kinetic -= stage_phi_[e] * (motion_->flux()[e] + flux[e]) / 2;
  }
  let_in(scope, dt, flux);
  move(scope, x, new_phi_, flux, rates_.x);
  expect_kinetic_energy(dt, x, flux);
  const double inertia_work = drives() ? dt * driven_->power(force_) : 0;
  if (first) {
    report_state(scope, kinetic, stage_phi_);
    remember(scope, kinetic + scope.report().potential_energy, stage_phi_);
  }
  count_work(scope, wire_work / 2 + inertia_work);
  scope.add_velocity(after, x, rates_.x);
  for (std::size_t v = 0; v < x.size(); ++v) x[v] += dt * rates_.x[v];
}

// x' = x + dt u((x + x')/2, (φ + φ')/2) and likewise φ': the iteration ends where positions change by less than 1e-12
// of δ, or after the last round.
void Conservative::midpoint(const Substep& step, Positions& x) {
  const double dt = step.dt, half = step.after + dt / 2;
  const Positions start = x;
  new_phi_ = phi_;
  long round = 0;
  for (double change = delta_; change > 1e-12 * delta_ && round < most_midpoint_rounds; ++round) {
    stage_x_.resize(x.size());
    stage_phi_.resize(phi_.size());
    for (std::size_t v = 0; v < x.size(); ++v) stage_x_[v] = (start[v] + x[v]) / 2;
    for (std::size_t e = 0; e < phi_.size(); ++e) stage_phi_[e] = (phi_[e] + new_phi_[e]) / 2;
    evaluate(step.scope, half, stage_x_, stage_phi_, rates_);
    step.scope.add_velocity(half, stage_x_, rates_.x);
    change = 0;
    for (std::size_t v = 0; v < x.size(); ++v) {
      const Vec3 next = start[v] + dt * rates_.x[v];
      change = std::max(change, (next - x[v]).norm());
      x[v] = next;
    }
    shift(view(phi_), dt, view(rates_.phi), new_phi_);
  }
  let_in(step.scope, dt, motion_->flux());
  step.scope.report().midpoint_rounds = std::max(step.scope.report().midpoint_rounds, round);
}

void Conservative::rk4(const Substep& step, Positions& x) {
  StepScope& scope = step.scope;
  const double dt = step.dt;
  const Positions start = x;
  let_in(scope, dt / 6, motion_->flux());
  scope.add_velocity(step.after, start, rates_.x);
  sum_ = rates_;
  const auto add_stage = [&](double in, double weight) {
    shift(view(start), in, view(rates_.x), stage_x_);
    shift(view(phi_), in, view(rates_.phi), stage_phi_);
    scope.correct_positions(step.after + in, stage_x_);
    evaluate(scope, step.after + in, stage_x_, stage_phi_, rates_);
    let_in(scope, weight * dt / 6, motion_->flux());
    scope.add_velocity(step.after + in, stage_x_, rates_.x);
    for (std::size_t v = 0; v < x.size(); ++v) sum_.x[v] += weight * rates_.x[v];
    for (std::size_t e = 0; e < phi_.size(); ++e) sum_.phi[e] += weight * rates_.phi[e];
  };
  add_stage(dt / 2, 2);
  add_stage(dt / 2, 2);
  add_stage(dt, 1);
  shift(view(start), dt / 6, view(sum_.x), x);
  shift(view(phi_), dt / 6, view(sum_.phi), new_phi_);
}

}  // namespace foamsim
