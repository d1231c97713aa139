#include "FoamSim/dynamics/conservative.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "Base/error.h"
#include "Base/timing/stopwatch.h"
#include "FoamSim/conservative/stable_step.h"

namespace foamsim {

using lostopos::Vec3;

namespace {

// Of the energy: what remeshing does to it in one step beyond this is dealt with at once; the rest is left to what
// corrects from step to step.
constexpr double negligible_share = 1e-4;

// out = x + h y
template <class T>
void shift(std::span<const T> x, double h, std::span<const T> y, std::vector<T>& out) {
  out.resize(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) out[i] = x[i] + h * y[i];
}

Vec3 mean_position(const FilmConnectivity& films, std::span<const Vec3> x) {
  const Vec3& first = x[films.corners.front()[0]];
  Vec3 sum = Vec3::Zero();
  for (const auto& corners : films.corners) sum += (x[corners[0]] - first) / static_cast<double>(films.corners.size());
  return first + sum;
}

template <class T>
std::span<const T> view(const std::vector<T>& values) {
  return values;
}

}  // namespace

double Conservative::attach(lostopos::SurfaceMesh& mesh, const DynamicsStart& start) {
  delta_ = start.delta > 0 ? start.delta : 0.5 * start.resolution;
  // A vertex has a third of six equilateral triangles, at a border of three in each film.
  const double regular = std::sqrt(3.0) / 4 * start.resolution * start.resolution;
  if (options_.near_field) near_ = NearField(delta_, 0.5 * regular);
  motion_.emplace(delta_, near_);
  change_.emplace(delta_, near_);
  viscosity_.emplace(options_.viscosity);
  potential_.emplace(mesh, options_.conserving_transfers);
  return delta_;
}

void Conservative::advance(StepScope& scope, Positions& predicted) {
  const long before = motion_->evaluations() + change_->evaluations();
  start(scope);
  switch (options_.stepping) {
    case Stepping::kick_drift:
      kick_drift(scope, predicted);
      break;
    case Stepping::midpoint:
      midpoint(scope, predicted);
      break;
    case Stepping::rk4:
      rk4(scope, predicted);
      break;
  }
  scope.correct_positions(scope.step().dt, predicted);
  surface_energy_ = scope.potential_energy(scope.step().dt, predicted);
  potential_->scatter(films_, new_phi_);
  put_circulation(films_, new_phi_, scope.circulation());
  scope.report().velocity_evaluations = motion_->evaluations() + change_->evaluations() - before;
}

nlohmann::json Conservative::state() const {
  if (!kept_) return nlohmann::json::object();
  const auto of = [](const Invariants& i) {
    return nlohmann::json{i.energy,
                          i.impulse.x(),
                          i.impulse.y(),
                          i.impulse.z(),
                          i.angular_impulse.x(),
                          i.angular_impulse.y(),
                          i.angular_impulse.z()};
  };
  return {{"kept", of(*kept_)},
          {"missing", of(missing_)},
          {"expected_kinetic_energy", expected_kinetic_},
          {"surface_energy", surface_energy_},
          {"about", {about_.x(), about_.y(), about_.z()}}};
}

void Conservative::restore(const nlohmann::json& state) {
  if (!state.is_object()) throw base::InputError("the state is not one of the conservative dynamics");
  if (state.empty()) {
    kept_.reset();
    return;
  }
  const auto from = [](const nlohmann::json& v) {
    const auto number = [&v](std::size_t i) { return v.at(i).get<double>(); };
    return Invariants{number(0), {number(1), number(2), number(3)}, {number(4), number(5), number(6)}};
  };
  const Invariants kept = from(state.at("kept")), missing = from(state.at("missing"));
  expected_kinetic_ = state.at("expected_kinetic_energy");
  surface_energy_ = state.at("surface_energy");
  const nlohmann::json& about = state.at("about");
  about_ = Vec3(about.at(0).get<double>(), about.at(1).get<double>(), about.at(2).get<double>());
  kept_ = kept;
  missing_ = missing;
}

void Conservative::start(StepScope& scope) {
  const base::TimedScope timed(scope.report().times, "films");
  films_.update(scope.mesh(), scope.step().geometry, scope.step().held, scope.solid());
  if (viscosity_->acts()) viscosity_->connect(scope.mesh(), scope.solid());
  phi_.resize(films_.entries());
  potential_->gather(films_, phi_);
  // A scene may have set Γ before the first step; from then on the potentials are what counts.
  if (potential_->empty()) take_circulation(films_, scope.circulation(), phi_);
  put_circulation(films_, phi_, scope.circulation());
  scope.change_circulation({});
  take_circulation(films_, scope.circulation(), phi_);
}

void Conservative::evaluate(StepScope& scope, double after, std::span<const Vec3> x, std::span<const double> phi,
                            Rates& rates) {
  {
    const base::TimedScope timed(scope.report().times, "velocity");
    shape_.update(films_, x);
    motion_->evaluate(films_, shape_, x, phi, PairTerms::all);
  }
  const base::TimedScope timed(scope.report().times, "forces");
  if (options_.tangential == Tangential::none)
    tangential_.assign(films_.vertex_slots(), Vec3::Zero());
  else
    mean_at_vertices(films_, shape_, motion_->velocity(), tangential_);
  rates.x.resize(films_.vertex_slots());
  fit_velocities(films_, shape_, motion_->flux(), tangential_, rates.x);
  if (options_.tangential == Tangential::smoothed) {
    add_smoothing(films_, shape_, x, rates.x, tangential_);
    fit_velocities(films_, shape_, motion_->flux(), tangential_, rates.x);
  }
  force_.assign(films_.vertex_slots(), Vec3::Zero());
  scope.add_force(after, x, force_);
  if (options_.inertia) motion_->add_inertia(films_, shape_, x, rates.x, force_);
  rates.phi.resize(films_.entries());
  balance(films_, shape_, force_, rates.phi);
  slip_power_ = unbalanced_power(films_, shape_, force_, rates.phi, rates.x);
  for (double& rate : rates.phi) rate /= 2;
}

void Conservative::kick_drift(StepScope& scope, Positions& predicted) {
  const double dt = scope.step().dt;
  predicted.assign(scope.positions().begin(), scope.positions().end());
  StepReport& report = scope.report();
  report.substeps = 0;
  double done = 0;
  for (long left = options_.most_substeps; left > 0; --left) {
    if (report.substeps > 0) phi_ = new_phi_;
    evaluate(scope, done, predicted, phi_, rates_);
    if (report.substeps == 0) take_back_remeshing(scope);
    LocalResponse response(films_, shape_, predicted, delta_, near_);
    const double longest = longest_substep(scope, predicted, response);
    const double parts = std::clamp(std::ceil((dt - done) / longest), 1.0, static_cast<double>(left));
    const double part = (dt - done) / parts;
    ++report.substeps;
    substep(scope, done, part, response, predicted);
    if (parts == 1) break;
    done += part;
  }
}

// By what the films' stiffness and their speed allow now.
double Conservative::longest_substep(StepScope& scope, std::span<const Vec3> x, LocalResponse& response) const {
  const base::TimedScope timed(scope.report().times, "step length");
  const double stable = stable_step(films_, shape_, x, scope.tension(), response);
  double& shortest = scope.report().stable_dt;
  shortest = scope.report().substeps == 0 ? stable : std::min(shortest, stable);
  return std::min(options_.safety * stable, options_.largest_strain * resolved_step(films_, x, rates_.x));
}

void Conservative::substep(StepScope& scope, double after, double dt, LocalResponse& response, Positions& x) {
  const bool first = after == 0;
  const base::TimedScope timed(scope.report().times, "kick");
  if (viscosity_->acts()) {
    const long iterations = viscosity_->add_force(response, dt, rates_.x, force_);
    long& most = scope.report().viscosity_iterations;
    most = std::max(most, iterations);
    balance(films_, shape_, force_, rates_.phi);
    for (double& rate : rates_.phi) rate /= 2;
  }
  shift(view(phi_), dt, view(rates_.phi), new_phi_);
  if (first) correct(scope, new_phi_);
  stage_phi_.resize(phi_.size());
  for (std::size_t e = 0; e < phi_.size(); ++e) stage_phi_[e] = new_phi_[e] - phi_[e];
  change_->evaluate(films_, shape_, x, stage_phi_, PairTerms::potential);
  // φ half-way between before and after the kick belongs to the positions.
  std::vector<double> flux(films_.entries());
  double kinetic = 0;
  for (std::size_t e = 0; e < flux.size(); ++e) {
    flux[e] = motion_->flux()[e] + change_->flux()[e];
    stage_phi_[e] = (phi_[e] + new_phi_[e]) / 2;
    kinetic -= stage_phi_[e] * (motion_->flux()[e] + flux[e]) / 2;
  }
  fit_velocities(films_, shape_, flux, tangential_, rates_.x);
  expect_kinetic_energy(dt, x, flux);
  if (first) {
    report_state(scope, kinetic, stage_phi_);
    remember(scope, kinetic + scope.report().potential_energy, stage_phi_);
  }
  scope.add_velocity(after, x, rates_.x);
  for (std::size_t v = 0; v < x.size(); ++v) x[v] += dt * rates_.x[v];
}

// x' = x + dt u((x + x')/2, (φ + φ')/2) and likewise φ': the iteration ends where positions change by less than 1e-12
// of δ, or after 30 rounds.
void Conservative::midpoint(StepScope& scope, Positions& predicted) {
  constexpr int most_rounds = 30;
  const double dt = scope.step().dt;
  const auto x = scope.positions();
  predicted.assign(x.begin(), x.end());
  new_phi_ = phi_;
  for (int round = 0; round < most_rounds; ++round) {
    stage_x_.resize(x.size());
    stage_phi_.resize(phi_.size());
    for (std::size_t v = 0; v < x.size(); ++v) stage_x_[v] = (x[v] + predicted[v]) / 2;
    for (std::size_t e = 0; e < phi_.size(); ++e) stage_phi_[e] = (phi_[e] + new_phi_[e]) / 2;
    evaluate(scope, dt / 2, stage_x_, stage_phi_, rates_);
    if (round == 0) report_state(scope, motion_->kinetic_energy(), phi_);
    scope.add_velocity(dt / 2, stage_x_, rates_.x);
    double change = 0;
    for (std::size_t v = 0; v < x.size(); ++v) {
      const Vec3 next = x[v] + dt * rates_.x[v];
      change = std::max(change, (next - predicted[v]).norm());
      predicted[v] = next;
    }
    shift(view(phi_), dt, view(rates_.phi), new_phi_);
    if (change < 1e-12 * delta_) break;
  }
}

void Conservative::rk4(StepScope& scope, Positions& predicted) {
  const double dt = scope.step().dt;
  const auto x = scope.positions();
  evaluate(scope, 0, x, phi_, rates_);
  report_state(scope, motion_->kinetic_energy(), phi_);
  scope.add_velocity(0, x, rates_.x);
  sum_ = rates_;
  const auto add_stage = [&](double after, double weight) {
    shift(x, after, view(rates_.x), stage_x_);
    shift(view(phi_), after, view(rates_.phi), stage_phi_);
    scope.correct_positions(after, stage_x_);
    evaluate(scope, after, stage_x_, stage_phi_, rates_);
    scope.add_velocity(after, stage_x_, rates_.x);
    for (std::size_t v = 0; v < x.size(); ++v) sum_.x[v] += weight * rates_.x[v];
    for (std::size_t e = 0; e < phi_.size(); ++e) sum_.phi[e] += weight * rates_.phi[e];
  };
  add_stage(dt / 2, 2);
  add_stage(dt / 2, 2);
  add_stage(dt, 1);
  shift(x, dt / 6, view(sum_.x), predicted);
  shift(view(phi_), dt / 6, view(sum_.phi), new_phi_);
}

// K of the predicted positions: that of the new φ at the old ones, and what the inertia force does on the way.
void Conservative::expect_kinetic_energy(double dt, std::span<const Vec3> x, std::span<const double> flux) {
  double kinetic = 0;
  for (std::size_t e = 0; e < flux.size(); ++e) kinetic -= new_phi_[e] * flux[e];
  force_.assign(films_.vertex_slots(), Vec3::Zero());
  motion_->add_inertia(films_, shape_, x, rates_.x, force_);
  for (std::size_t v = 0; v < force_.size(); ++v) kinetic += dt * force_[v].dot(rates_.x[v]);
  expected_kinetic_ = kinetic;
}

// Energy that remeshing has put into the air in one go: taken from where it shows most.
void Conservative::take_back_remeshing(StepScope& scope) {
  constexpr int most_rounds = 3;
  if (!kept_) return;
  scope.report().tracker_surface_energy = scope.potential_energy() - surface_energy_;
  scope.report().tracker_kinetic_energy = motion_->kinetic_energy() - expected_kinetic_;
  if (!options_.correction) return;
  for (int round = 0; round < most_rounds; ++round) {
    const double energy = motion_->kinetic_energy() + scope.potential_energy();
    const double surplus =
        energy - std::max(expected_kinetic_, 0.0) - std::max(surface_energy_, scope.potential_energy());
    if (surplus <= negligible_share * energy) return;
    Invariants wanted;
    wanted.energy = -std::min(surplus, 0.5 * motion_->kinetic_energy());
    scope.report().correction +=
        correct_invariants(films_, shape_, scope.positions(), about_, motion_->flux(), wanted, phi_);
    evaluate(scope, 0, scope.positions(), phi_, rates_);
  }
}

void Conservative::correct(StepScope& scope, std::vector<double>& phi) {
  if (!options_.correction || !kept_) return;
  // No more than a fifth of the kinetic energy: of air nearly at rest there is nothing to be had.
  // Of a change in the kick half shows at once: half of what is missing a step, a little more of energy, and what the
  // step to come is about to put in by moving the mesh along the films.
  Invariants wanted = missing_;
  wanted.impulse /= 2;
  wanted.angular_impulse /= 2;
  wanted.energy = 0.8 * wanted.energy - scope.step().dt * slip_power_;
  const double most = 0.2 * std::max(0.0, motion_->kinetic_energy());
  wanted.energy = std::clamp(wanted.energy, -most, viscosity_->acts() ? 0.0 : most);
  scope.report().correction +=
      correct_invariants(films_, shape_, scope.positions(), about_, motion_->flux(), wanted, phi);
}

void Conservative::remember(StepScope& scope, double energy, std::span<const double> phi) {
  if (!kept_) about_ = mean_position(films_, scope.positions());
  Invariants now = impulses(films_, shape_, scope.positions(), about_, phi);
  now.energy = energy;
  if (kept_) {
    // Surface that remeshing has smoothed away is gone; what it has added has to come from the air.
    kept_->energy += std::min(0.0, scope.report().potential_energy - surface_energy_);
    const double air = scope.report().tracker_kinetic_energy;
    if (air < -negligible_share * now.energy) kept_->energy += air;
    missing_ = {kept_->energy - now.energy, kept_->impulse - now.impulse, kept_->angular_impulse - now.angular_impulse};
    // What viscosity takes away is not to come back.
    if (viscosity_->acts()) kept_->energy = std::min(kept_->energy, now.energy);
  } else {
    kept_ = now;
  }
}

void Conservative::report_state(StepScope& scope, double kinetic_energy, std::span<const double> phi) const {
  StepReport& report = scope.report();
  report.kinetic_energy = kinetic_energy;
  report.potential_energy = scope.potential_energy();
  const FilmImpulse now = impulse(films_, shape_, phi);
  report.impulse = now.total;
  report.impulse_scale = now.scale;
}

}  // namespace foamsim
