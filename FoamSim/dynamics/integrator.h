#pragma once

#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "LosTopos/vec3.h"

namespace foamsim {

/// How positions are advanced in the velocity field of a step's fixed circulation.
enum class Integrator {
  euler,  ///< explicit Euler: x + u(x) dt
  rk4,    ///< the classical fourth-order Runge–Kutta method: velocities again at three stage positions
};

/// Throws base::InputError for an unknown name.
Integrator integrator_by_name(std::string_view name);
std::string_view name(Integrator integrator);

/// Writes the velocity (L/T) of points at `positions` into `velocity`; both have one entry a vertex slot.
using VelocityFunction =
    std::function<void(std::span<const lostopos::Vec3> positions, std::span<lostopos::Vec3> velocity)>;

/// Predicted positions after dt from x, given the velocity u there. Calls `velocity_at` three times for rk4, never for
/// euler.
void integrate(Integrator integrator, double dt, std::span<const lostopos::Vec3> x, std::span<const lostopos::Vec3> u,
               const VelocityFunction& velocity_at, std::vector<lostopos::Vec3>& predicted);

}  // namespace foamsim
