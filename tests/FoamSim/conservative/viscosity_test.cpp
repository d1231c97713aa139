#include "FoamSim/conservative/viscosity.h"

#include <gtest/gtest.h>

#include "FoamSim/conservative/stable_step.h"
#include "FoamSim/scenes/shapes/double_bubble.h"
#include "FoamSim/scenes/shapes/solids.h"
#include "tests/FoamSim/conservative/film_system.h"

namespace foamsim {
namespace {

using lostopos::Vec3;

// A kick by the viscosity alone, φ += dt P/2, of a step of any length.
double energy_left(double coefficient, double dt) {
  const lostopos::SurfaceMesh mesh = double_bubble(8);
  const test::FilmSystem system(mesh);
  std::vector<double> phi = system.random_phi();
  const FilmMotion motion = system.motion(phi, 0.15);
  std::vector<Vec3> u(system.x.size()), force(system.x.size(), Vec3::Zero());
  const std::vector<Vec3> still(system.x.size(), Vec3::Zero());
  fit_velocities(system.films, system.shape, motion.flux(), still, u);
  Viscosity viscosity(coefficient, 0.3);
  viscosity.connect(mesh, {});
  viscosity.add_force(system.films, system.shape, system.x, dt, u, force);
  std::vector<double> pressure(phi.size());
  balance(system.films, system.shape, force, pressure);
  for (std::size_t e = 0; e < phi.size(); ++e) phi[e] += dt / 2 * pressure[e];
  return system.motion(phi, 0.15).kinetic_energy() / motion.kinetic_energy();
}

TEST(Viscosity, TakesEnergyAwayAlsoInLongSteps) {
  double last = 1;
  for (double dt : {1e-3, 1e-2, 1e-1, 1.0}) {
    const double left = energy_left(0.5, dt);
    EXPECT_LT(left, last) << dt;
    EXPECT_GT(left, 0) << dt;
    last = left;
  }
  EXPECT_EQ(energy_left(0, 0.1), 1);
}

// dK/dt = −2R in the limit of short steps.
TEST(Viscosity, TakesTwiceItsRayleighFunction) {
  const lostopos::SurfaceMesh mesh = icosphere(1);
  const test::FilmSystem system(mesh);
  std::vector<double> phi = system.random_phi(3);
  const FilmMotion motion = system.motion(phi, 0.2);
  std::vector<Vec3> u(system.x.size()), force(system.x.size(), Vec3::Zero());
  const std::vector<Vec3> still(system.x.size(), Vec3::Zero());
  fit_velocities(system.films, system.shape, motion.flux(), still, u);
  constexpr double eta = 0.3, dt = 1e-7;
  Viscosity viscosity(eta, 0.5);
  viscosity.connect(mesh, {});
  viscosity.add_force(system.films, system.shape, system.x, dt, u, force);
  double twice = 0;
  for (lostopos::Edge e : mesh.edges()) {
    const auto v = mesh.vertices(e);
    twice += eta / std::sqrt(3.0) * (u[v[0].index()] - u[v[1].index()]).squaredNorm();
  }
  std::vector<double> pressure(phi.size());
  balance(system.films, system.shape, force, pressure);
  for (std::size_t e = 0; e < phi.size(); ++e) phi[e] += dt / 2 * pressure[e];
  const double rate = (system.motion(phi, 0.2).kinetic_energy() - motion.kinetic_energy()) / dt;
  EXPECT_NEAR(rate, -twice, 1e-3 * twice);
}

// Lengths by 2 and tension by 3: ω² goes with tension over length cubed.
TEST(StableStep, ScalesAsTheFrequencyOfWaves) {
  test::FilmSystem system(icosphere(2));
  const double step = stable_step(system.films, system.shape, system.x, 4, 0.1);
  for (Vec3& x : system.x) x *= 2;
  system.shape.update(system.films, system.x);
  EXPECT_NEAR(stable_step(system.films, system.shape, system.x, 12, 0.2), step * std::sqrt(8.0 / 3), 1e-9 * step);
  EXPECT_EQ(stable_step(system.films, system.shape, system.x, 0, 0.2), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace foamsim
