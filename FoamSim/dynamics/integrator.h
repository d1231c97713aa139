#pragma once

#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "Base/options/option_set.h"
#include "Base/registry/registry.h"
#include "FoamSim/dynamics/integrator_kick.h"
#include "LosTopos/vec3.h"

namespace foamsim {

/// What an integrator may ask of the step: both for an instant `after` (T) the step's start, in arrays of one entry a
/// vertex slot.
struct StageMotion {
  /// Writes the velocity (L/T) of points at `positions` (L).
  std::function<void(double after, std::span<const lostopos::Vec3> positions, std::span<lostopos::Vec3> velocity)>
      velocity;
  /// Lets effects and constraints change positions that have been arrived at; to be called for those of every stage and
  /// for those at the end.
  std::function<void(double after, std::span<lostopos::Vec3> positions)> correct;
};

/// How positions are advanced in the velocity field of a step's circulation, which some integrators change themselves
/// first.
class Integrator {
 public:
  Integrator() = default;
  Integrator(const Integrator&) = delete;
  Integrator& operator=(const Integrator&) = delete;
  virtual ~Integrator() = default;
  /// Whether it changes Γ by the films' tension, in place of the effect surface_tension.
  virtual bool takes_tension() const { return false; }
  /// Does so, before the effects change Γ; returns how many rounds that took. Throws base::Error where there is no
  /// solution to be found.
  virtual long kick(const CirculationKick& /*kick*/) { return 0; }
  /// Predicted positions after dt (T) from x, given the velocity u there.
  virtual void advance(double dt, std::span<const lostopos::Vec3> x, std::span<const lostopos::Vec3> u,
                       const StageMotion& motion, std::vector<lostopos::Vec3>& predicted) = 0;
};

/// Explicit Euler: x + u(x) dt. Asks for no further velocity.
class Euler final : public Integrator {
 public:
  void advance(double dt, std::span<const lostopos::Vec3> x, std::span<const lostopos::Vec3> u,
               const StageMotion& motion, std::vector<lostopos::Vec3>& predicted) override;
};

/// The classical fourth-order Runge–Kutta method: velocities again at three stage positions.
class RungeKutta4 final : public Integrator {
 public:
  void advance(double dt, std::span<const lostopos::Vec3> x, std::span<const lostopos::Vec3> u,
               const StageMotion& motion, std::vector<lostopos::Vec3>& predicted) override;

 private:
  std::vector<lostopos::Vec3> stage_, k_, sum_;
};

/// What an integrator may be made from: the options, with its own.
struct IntegratorSetup {
  const base::OptionSet& options;
};
using IntegratorEntry = base::Model<Integrator, IntegratorSetup>;

/// The built-in integrators: euler, rk4, implicit, pbd.
const base::Registry<IntegratorEntry>& integrators();

/// A built-in integrator with the defaults of its options. Throws base::InputError for an unknown name.
std::unique_ptr<Integrator> make_integrator(std::string_view name);

/// Whether the built-in integrator of this name takes the films' tension; false for any other name.
bool takes_tension(std::string_view name);

}  // namespace foamsim
