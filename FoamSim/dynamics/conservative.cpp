#include "FoamSim/dynamics/conservative.h"

#include <algorithm>
#include <cmath>

#include "Base/timing/stopwatch.h"
#include "FoamSim/conservative/stable_step.h"

namespace foamsim {

using lostopos::Vec3;

namespace {

// Of h^1.5/√tension: steps that regular triangles bear are 0.9 of it, those at a Plateau border 0.45.
constexpr double least_share = 0.25;

}  // namespace

double Conservative::attach(lostopos::SurfaceMesh& mesh, const DynamicsStart& start) {
  resolution_ = start.resolution;
  delta_ = start.delta > 0 ? start.delta : 0.5 * start.resolution;
  // A vertex has a third of six equilateral triangles, at a border of three in each film.
  const double regular = std::sqrt(3.0) / 4 * start.resolution * start.resolution;
  if (options_.near_field) near_ = NearField(delta_, 0.5 * regular);
  const std::shared_ptr<PairSummation> pairs = summation_->pair_sums(options_.precision);
  motion_.emplace(delta_, near_, pairs);
  change_.emplace(delta_, near_, pairs);
  driven_.emplace(delta_, near_);
  viscosity_.emplace(options_.viscosity);
  potential_.emplace(mesh, options_.conserving_transfers);
  return delta_;
}

double Conservative::suitable_dt(const EffectStep& step, double tension) {
  films_.update(step.mesh, step.geometry, step.held, step.solid);
  shape_.update(films_, step.mesh.positions());
  LocalResponse response(films_, shape_, step.mesh.positions(), delta_, near_);
  const double stable = stable_step(films_, shape_, step.mesh.positions(), tension, response);
  return std::max(options_.safety * stable, least_share * std::sqrt(std::pow(resolution_, 3) / tension));
}

void Conservative::advance(StepScope& scope, Positions& predicted) {
  const long before = evaluations();
  start(scope);
  predicted.assign(scope.positions().begin(), scope.positions().end());
  const double dt = scope.step().dt;
  long& substeps = scope.report().substeps;
  substeps = 0;
  double done = 0;
  for (long left = options_.most_substeps; left > 0; --left) {
    if (substeps > 0) phi_ = new_phi_;
    evaluate(scope, done, predicted, phi_, rates_);
    if (substeps == 0) {
      if (!blown_.empty()) count_drive(scope);
      take_back_remeshing(scope);
      if (start_wires(scope, predicted)) evaluate(scope, done, predicted, phi_, rates_);
    }
    LocalResponse response(films_, shape_, predicted, delta_, near_);
    const double longest = longest_substep(scope, predicted, response);
    const double parts = std::clamp(std::ceil((dt - done) / longest), 1.0, static_cast<double>(left));
    const double part = (dt - done) / parts;
    ++substeps;
    substep({scope, done, part, response}, predicted);
    if (parts == 1) break;
    done += part;
  }
  scope.correct_positions(dt, predicted);
  count_surface_work(scope, predicted);
  surface_energy_ = scope.potential_energy(dt, predicted);
  potential_->scatter(films_, new_phi_);
  put_circulation(films_, new_phi_, scope.circulation());
  scope.report().velocity_evaluations = evaluations() - before;
}

long Conservative::evaluations() const {
  return motion_->evaluations() + change_->evaluations() + (sheet_sum_ ? sheet_sum_->evaluations() : 0);
}

void Conservative::start(StepScope& scope) {
  const base::TimedScope timed(scope.report().times, "films");
  gather(scope.step(), scope.circulation());
  if (viscosity_->acts()) viscosity_->connect(scope.mesh(), scope.solid());
  put_circulation(films_, phi_, scope.circulation());
  blown_.clear();
  if (scope.drives()) drive(scope);
  scope.change_circulation({});
  take_circulation(films_, scope.circulation(), phi_);
  begin_wires(scope);
}

void Conservative::gather(const EffectStep& step, CirculationField& circulation) {
  films_.update(step.mesh, step.geometry, step.held, step.solid);
  phi_.resize(films_.entries());
  potential_->gather(films_, phi_);
  // A scene may have set Γ before the first step; from then on the potentials are what counts.
  if (potential_->at_rest()) take_circulation(films_, circulation, phi_);
}

void Conservative::evaluate(StepScope& scope, double after, std::span<const Vec3> x, std::span<const double> phi,
                            Rates& rates) {
  {
    const base::TimedScope timed(scope.report().times, "velocity");
    shape_.update(films_, x);
    if (drives_air() && options_.stepping != Stepping::kick_drift) phi = held_at_stage(scope, x, phi);
    motion_->evaluate(films_, shape_, x, phi, PairTerms::all);
  }
  const base::TimedScope timed(scope.report().times, "forces");
  if (options_.tangential == Tangential::none)
    tangential_.assign(films_.vertex_slots(), Vec3::Zero());
  else
    mean_at_vertices(films_, shape_, motion_->velocity(), tangential_);
  move(scope, x, phi, motion_->flux(), rates.x);
  if (options_.tangential == Tangential::smoothed && !sheet_sum_) {
    add_smoothing(films_, shape_, x, rates.x, tangential_);
    move(scope, x, phi, motion_->flux(), rates.x);
  }
  force_.assign(films_.vertex_slots(), Vec3::Zero());
  scope.add_force(after, x, force_);
  if (options_.inertia) motion_->add_inertia(films_, shape_, x, rates.x, force_);
  press(rates.phi);
  slip_power_ = unbalanced_power(films_, shape_, force_, pressure_, rates.x);
  if (drives()) slip_power_ -= driven_->power(force_);
}

void Conservative::move(StepScope& scope, std::span<const Vec3> x, std::span<const double> phi,
                        std::span<const double> flux, Positions& velocity) {
  velocity.resize(films_.vertex_slots());
  if (!sheet_sum_) {
    fit_velocities(films_, shape_, flux, tangential_, velocity);
    driven_->prescribe(velocity);
    return;
  }
  put_circulation(films_, phi, scope.circulation());
  gather_sheet(scope.mesh(), scope.circulation(), sheet_, scope.solid());
  sheet_sum_->evaluate(sheet_, x, x, delta_, velocity);
}

void Conservative::press(std::vector<double>& phi_rate) {
  pressure_.resize(films_.entries());
  balance(films_, shape_, force_, pressure_);
  phi_rate.resize(pressure_.size());
  for (std::size_t e = 0; e < pressure_.size(); ++e) phi_rate[e] = pressure_[e] / 2;
}

// By what the films' stiffness and their speed allow now.
double Conservative::longest_substep(StepScope& scope, std::span<const Vec3> x, LocalResponse& response) const {
  const base::TimedScope timed(scope.report().times, "step length");
  const double stable = stable_step(films_, shape_, x, scope.tension(), response);
  double& shortest = scope.report().stable_dt;
  shortest = scope.report().substeps == 0 ? stable : std::min(shortest, stable);
  return std::min(options_.safety * stable, options_.largest_strain * resolved_step(films_, x, rates_.x));
}

}  // namespace foamsim
