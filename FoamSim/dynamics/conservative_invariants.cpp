// What the conservative dynamics know of energy and impulse from step to step.

#include <algorithm>
#include <nlohmann/json.hpp>

#include "Base/json/checked_json.h"
#include "FoamSim/dynamics/conservative.h"

namespace foamsim {

using lostopos::Vec3;

namespace {

// Of the energy: what remeshing does to it in one step beyond this is dealt with at once; the rest is left to what
// corrects from step to step.
constexpr double negligible_share = 1e-4;

Vec3 mean_position(const FilmConnectivity& films, std::span<const Vec3> x) {
  const Vec3& first = x[films.corners.front()[0]];
  Vec3 sum = Vec3::Zero();
  for (const auto& corners : films.corners) sum += (x[corners[0]] - first) / static_cast<double>(films.corners.size());
  return first + sum;
}

}  // namespace

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
          {"wire_work", wire_due_},
          {"about", {about_.x(), about_.y(), about_.z()}}};
}

void Conservative::restore(const nlohmann::json& json_state) {
  const base::CheckedJson state(json_state, "the state of the conservative dynamics");
  if (!json_state.is_object()) state.refuse("is one of other dynamics");
  if (json_state.empty()) {
    kept_.reset();
    return;
  }
  const auto from = [](const base::CheckedJson& value) {
    const std::vector<double> x = value.finite_numbers(7);
    return Invariants{x[0], {x[1], x[2], x[3]}, {x[4], x[5], x[6]}};
  };
  const Invariants kept = from(state.at("kept")), missing = from(state.at("missing"));
  const std::vector<double> about = state.at("about").finite_numbers(3);
  expected_kinetic_ = state.at("expected_kinetic_energy").finite_number();
  surface_energy_ = state.at("surface_energy").finite_number();
  wire_due_ = state.at("wire_work").finite_number();
  about_ = Vec3(about[0], about[1], about[2]);
  kept_ = kept;
  missing_ = missing;
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
    kept_->energy += wire_due_;
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
  wire_due_ = 0;
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
