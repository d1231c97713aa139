#include "FoamSim/dynamics/integrator.h"

#include <array>

#include "Base/names/nearest_name.h"

namespace foamsim {

using lostopos::Vec3;

namespace {

struct Entry {
  std::string_view name;
  Integrator integrator;
};
constexpr std::array entries{Entry{"euler", Integrator::euler}, Entry{"rk4", Integrator::rk4}};

// out = x + h u
void shift(std::span<const Vec3> x, double h, std::span<const Vec3> u, std::span<Vec3> out) {
  for (std::size_t i = 0; i < x.size(); ++i) out[i] = x[i] + h * u[i];
}

}  // namespace

Integrator integrator_by_name(std::string_view name) {
  return base::find_by_name(entries, name, "integrator").integrator;
}

std::string_view name(Integrator integrator) {
  return entries[static_cast<std::size_t>(integrator)].name;
}

void integrate(Integrator integrator, double dt, std::span<const Vec3> x, std::span<const Vec3> u,
               const VelocityFunction& velocity_at, std::vector<Vec3>& predicted) {
  predicted.resize(x.size());
  if (integrator == Integrator::euler) {
    shift(x, dt, u, predicted);
    return;
  }
  std::vector<Vec3> stage(x.size()), k(x.size());
  std::vector<Vec3> sum(u.begin(), u.end());
  shift(x, dt / 2, u, stage);
  velocity_at(stage, k);
  shift(sum, 2, k, sum);
  shift(x, dt / 2, k, stage);
  velocity_at(stage, k);
  shift(sum, 2, k, sum);
  shift(x, dt, k, stage);
  velocity_at(stage, k);
  shift(sum, 1, k, sum);
  shift(x, dt / 6, sum, predicted);
}

}  // namespace foamsim
