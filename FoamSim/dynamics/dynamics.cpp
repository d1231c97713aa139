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

void StepScope::change_circulation(const SheetVelocities& velocities) {
  for (const auto& effect : effects_) {
    const base::TimedScope timed(report_.times, effect->name());
    effect->update_circulation(step_, circulation_);
  }
  for (const auto& constraint : constraints_) {
    const base::TimedScope timed(report_.times, constraint->name());
    constraint->correct_circulation(step_, circulation_, velocities);
  }
}

void StepScope::add_velocity(double after, std::span<const Vec3> positions, std::span<Vec3> velocity) {
  const Stage stage{step_, step_.time + after, positions};
  const std::vector<Vec3> before(velocity.begin(), velocity.end());
  for (const auto& effect : effects_) {
    const base::TimedScope timed(report_.times, effect->name());
    effect->add_velocity(stage, velocity);
  }
  if (std::ranges::equal(before, velocity)) return;
  std::vector<Vec3> added(velocity.begin(), velocity.end());
  for (std::size_t i = 0; i < added.size(); ++i) added[i] -= before[i];
  for (const auto& effect : effects_) effect->velocity_added(stage, added);
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
