#include "FoamSim/dynamics/dynamics.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "Base/error.h"
#include "Base/timing/stopwatch.h"

namespace foamsim {

using lostopos::Vec3;

nlohmann::json Dynamics::state() const {
  return nullptr;
}

void Dynamics::restore(const nlohmann::json& state) {
  if (!state.is_null()) throw base::InputError("the state is one of other dynamics");
}

bool StepScope::drives() const {
  return std::ranges::any_of(effects_, [this](const auto& effect) { return effect->drives(step_.time); });
}

void StepScope::drive_circulation() {
  for (const auto& effect : effects_) {
    if (!effect->drives(step_.time)) continue;
    const base::TimedScope timed(report_.times, effect->name());
    effect->drive_circulation(step_, circulation_);
  }
}

void StepScope::let_in(lostopos::Region region, double volume) {
  for (const auto& effect : effects_) effect->volume_let_in(region, volume);
}

void StepScope::change_circulation(const SheetAir& air) {
  for (const auto& effect : effects_) {
    const base::TimedScope timed(report_.times, effect->name());
    effect->update_circulation(step_, circulation_);
  }
  for (const auto& constraint : constraints_) {
    const base::TimedScope timed(report_.times, constraint->name());
    const AirChange change = constraint->correct_circulation(step_, circulation_, air);
    report_.wire_iterations = std::max(report_.wire_iterations, change.iterations);
    report_.wire_work += change.work;
  }
}

HeldMotion StepScope::held_motion() const {
  HeldMotion motion;
  for (const auto& constraint : constraints_) constraint->tell_motion(step_, motion);
  return motion;
}

void StepScope::add_effect_velocity(std::span<const lostopos::Vertex> at, std::span<Vec3> velocity) {
  std::vector<Vec3> added(positions().size(), Vec3::Zero());
  for (const auto& effect : effects_) {
    const base::TimedScope timed(report_.times, effect->name());
    effect->add_velocity({step_, step_.time, positions()}, added);
  }
  for (std::size_t i = 0; i < at.size(); ++i) velocity[i] += added[at[i].index()];
}

void StepScope::add_velocity(double after, std::span<const Vec3> positions, std::span<Vec3> velocity) {
  const Stage stage{step_, step_.time + after, positions};
  const std::vector<Vec3> before(velocity.begin(), velocity.end());
  for (const auto& effect : effects_) {
    const base::TimedScope timed(report_.times, effect->name());
    effect->add_velocity(stage, velocity);
  }
  if (!std::ranges::equal(before, velocity)) {
    std::vector<Vec3> added(velocity.begin(), velocity.end());
    for (std::size_t i = 0; i < added.size(); ++i) added[i] -= before[i];
    for (const auto& effect : effects_) effect->velocity_added(stage, added);
    if (after == 0) report_.effect_work += work_of(added);
  }
  for (const auto& constraint : constraints_) {
    const base::TimedScope timed(report_.times, constraint->name());
    constraint->add_velocity(stage, velocity);
  }
}

// On the films, by velocities (L/T) that effects add.
double StepScope::work_of(std::span<const Vec3> velocity) const {
  std::vector<Vec3> moved(positions().begin(), positions().end());
  for (std::size_t v = 0; v < moved.size(); ++v) moved[v] += step_.dt * velocity[v];
  return potential_energy(step_.dt, moved) - potential_energy(0, positions());
}

void StepScope::add_force(double after, std::span<const Vec3> positions, std::span<Vec3> force) {
  for (const auto& effect : effects_) {
    const base::TimedScope timed(report_.times, effect->name());
    effect->add_force({step_, step_.time + after, positions}, force);
  }
}

void StepScope::correct_positions(double after, std::span<Vec3> positions) {
  for (const auto& effect : effects_) {
    const base::TimedScope timed(report_.times, effect->name());
    effect->move_vertices({step_, step_.time + after, positions}, positions);
  }
  for (const auto& constraint : constraints_) {
    const base::TimedScope timed(report_.times, constraint->name());
    constraint->prescribe({step_, step_.time + after, positions}, positions);
  }
}

double StepScope::potential_energy() const {
  double sum = 0;
  for (const auto& effect : effects_) sum += effect->potential_energy(step_.geometry);
  return sum;
}

double StepScope::tension() const {
  double sum = 0;
  for (const auto& effect : effects_) sum += effect->tension();
  return sum;
}

double StepScope::potential_energy(double after, std::span<const Vec3> positions) const {
  double sum = 0;
  for (const auto& effect : effects_) sum += effect->potential_energy({step_, step_.time + after, positions});
  return sum;
}

}  // namespace foamsim
