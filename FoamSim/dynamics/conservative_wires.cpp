// How the conservative dynamics take the air along with what wires hold.

#include "Base/timing/stopwatch.h"
#include "FoamSim/dynamics/conservative.h"

namespace foamsim {

using lostopos::Vec3;

// Through a mouth air flows as it is blown, not as a wire says.
void Conservative::begin_wires(StepScope& scope) {
  HeldMotion motion = scope.held_motion();
  for (std::size_t v = 0; v < motion.takes_air.size(); ++v)
    if (scope.step().is_mouth(lostopos::Vertex(v))) motion.takes_air[v] = 0;
  driven_->begin(std::move(motion));
}

bool Conservative::start_wires(StepScope& scope, std::span<const Vec3> x) {
  // A kick sees to it by itself, but for velocities that are suddenly others: half-way through it would be too late.
  if (!drives_air() || (options_.stepping == Stepping::kick_drift && !driven_->jumps())) return false;
  const base::TimedScope timed(scope.report().times, "wire flux");
  change_->evaluate(films_, shape_, x, phi_, PairTerms::potential);
  count_work(scope, driven_->hold(films_, shape_, x, change_->flux(), true, phi_, scope.report().wire_iterations));
  return true;
}

double Conservative::hold_in_kick(StepScope& scope, std::span<const Vec3> x) {
  const base::TimedScope timed(scope.report().times, "wire flux");
  std::vector<double> flux(motion_->flux().begin(), motion_->flux().end());
  for (std::size_t e = 0; e < flux.size(); ++e) flux[e] += change_->flux()[e];
  const double work = driven_->hold(films_, shape_, x, flux, false, new_phi_, scope.report().wire_iterations);
  for (std::size_t e = 0; e < stage_phi_.size(); ++e) stage_phi_[e] = new_phi_[e] - phi_[e];
  change_->evaluate(films_, shape_, x, stage_phi_, PairTerms::potential);
  return work;
}

std::span<const double> Conservative::held_at_stage(StepScope& scope, std::span<const Vec3> x,
                                                    std::span<const double> phi) {
  held_phi_.assign(phi.begin(), phi.end());
  change_->evaluate(films_, shape_, x, held_phi_, PairTerms::potential);
  driven_->hold(films_, shape_, x, change_->flux(), false, held_phi_, scope.report().wire_iterations);
  return held_phi_;
}

void Conservative::count_work(StepScope& scope, double work) {
  scope.report().wire_work += work;
  wire_due_ += work;
}

void Conservative::count_surface_work(StepScope& scope, std::span<const Vec3> x) {
  if (!drives()) return;
  force_.assign(films_.vertex_slots(), Vec3::Zero());
  scope.add_force(0, scope.positions(), force_);
  scope.add_force(scope.step().dt, x, force_);
  count_work(scope, driven_->work(force_, scope.positions(), x));
}

void Conservative::count_inertia_work(StepScope& scope, double dt, std::span<const Vec3> x) {
  if (!drives()) return;
  force_.assign(films_.vertex_slots(), Vec3::Zero());
  motion_->add_inertia(films_, shape_, x, rates_.x, force_);
  count_work(scope, dt * driven_->power(force_));
}

}  // namespace foamsim
