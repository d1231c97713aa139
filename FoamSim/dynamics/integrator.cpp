#include "FoamSim/dynamics/integrator.h"

#include "FoamSim/dynamics/implicit.h"

namespace foamsim {

using lostopos::Vec3;

namespace {

// out = x + h u
void shift(std::span<const Vec3> x, double h, std::span<const Vec3> u, std::span<Vec3> out) {
  for (std::size_t i = 0; i < x.size(); ++i) out[i] = x[i] + h * u[i];
}

template <class Made>
std::unique_ptr<Integrator> make(const IntegratorSetup&) {
  return std::make_unique<Made>();
}

}  // namespace

void Euler::advance(double dt, std::span<const Vec3> x, std::span<const Vec3> u, const StageMotion& motion,
                    std::vector<Vec3>& predicted) {
  predicted.resize(x.size());
  shift(x, dt, u, predicted);
  motion.correct(dt, predicted);
}

void RungeKutta4::advance(double dt, std::span<const Vec3> x, std::span<const Vec3> u, const StageMotion& motion,
                          std::vector<Vec3>& predicted) {
  stage_.resize(x.size());
  k_.resize(x.size());
  sum_.assign(u.begin(), u.end());
  const auto add_stage = [&](double after, std::span<const Vec3> slope, double weight) {
    shift(x, after, slope, stage_);
    motion.correct(after, stage_);
    motion.velocity(after, stage_, k_);
    shift(sum_, weight, k_, sum_);
  };
  add_stage(dt / 2, u, 2);
  add_stage(dt / 2, k_, 2);
  add_stage(dt, k_, 1);
  predicted.resize(x.size());
  shift(x, dt / 6, sum_, predicted);
  motion.correct(dt, predicted);
}

const base::Registry<IntegratorEntry>& integrators() {
  static const base::Registry<IntegratorEntry> entries(
      "integrator",
      {{"euler", "explicit Euler", {}, make<Euler>},
       {"rk4", "the classical fourth-order Runge-Kutta method", {}, make<RungeKutta4>},
       {"implicit", "tension acts on circulation implicitly, by Newton-Krylov; then Euler", {}, make<Implicit>},
       {"pbd", "the same by Jacobi projections, for small surfaces", {}, make<PositionBased>}});
  return entries;
}

std::unique_ptr<Integrator> make_integrator(std::string_view name) {
  const IntegratorEntry& entry = integrators().find(name);
  const base::OptionSet own(entry.options);
  return entry.make({own});
}

bool takes_tension(std::string_view name) {
  return integrators().has(name) && make_integrator(name)->takes_tension();
}

}  // namespace foamsim
