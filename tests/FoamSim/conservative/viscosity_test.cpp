#include "FoamSim/conservative/viscosity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

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
  LocalResponse response(system.films, system.shape, system.x, 0.2, NearField());
  Viscosity viscosity(coefficient);
  viscosity.connect(mesh, {});
  viscosity.add_force(response, dt, u, force);
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
  LocalResponse response(system.films, system.shape, system.x, 0.2, NearField());
  Viscosity viscosity(eta);
  viscosity.connect(mesh, {});
  viscosity.add_force(response, dt, u, force);
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
  const auto step_at = [&system](double tension, double delta) {
    LocalResponse response(system.films, system.shape, system.x, delta, NearField());
    return stable_step(system.films, system.shape, system.x, tension, response);
  };
  const double step = step_at(4, 0.1);
  for (Vec3& x : system.x) x *= 2;
  system.shape.update(system.films, system.x);
  EXPECT_NEAR(step_at(12, 0.2), step * std::sqrt(8.0 / 3), 1e-9 * step);
  EXPECT_EQ(step_at(0, 0.2), std::numeric_limits<double>::infinity());
}

// A stretched film is stiffer than any of its vertices alone: rows of vertices that move together.
TEST(StableStep, IsThatOfTheFastestMotionThereIs) {
  test::FilmSystem system(icosphere(1));
  for (Vec3& x : system.x) x.x() *= 0.1;
  system.shape.update(system.films, system.x);
  constexpr double delta = 0.25, tension = 4;
  LocalResponse response(system.films, system.shape, system.x, delta, NearField());
  const double step = stable_step(system.films, system.shape, system.x, tension, response);
  // ẍ = −S H x with all the air, dense, and H of flat triangles: the largest eigenvalue.
  const std::size_t n = system.x.size();
  std::vector<Vec3> y(n), force(n), u(n);
  const std::vector<Vec3> still(n, Vec3::Zero());
  std::vector<double> pressure(system.films.entries());
  for (std::size_t v = 0; v < n; ++v) y[v] = Vec3(std::sin(7.0 * v), std::cos(5.0 * v), std::sin(3.0 * v + 1));
  double square = 0;
  for (int round = 0; round < 200; ++round) {
    std::ranges::fill(force, Vec3::Zero());
    for (std::size_t t = 0; t < system.films.corners.size(); ++t) {
      const Vec3 normal = system.shape.area_vector[t].normalized();
      Vec3 slope = Vec3::Zero();
      for (std::size_t k = 0; k < 3; ++k)
        slope += opposite_edge(system.films, t, k, system.x) * normal.dot(y[system.films.corners[t][k]]);
      for (std::size_t k = 0; k < 3; ++k)
        force[system.films.corners[t][k]] +=
            tension / (4 * system.shape.area[t]) * opposite_edge(system.films, t, k, system.x).dot(slope) * normal;
    }
    balance(system.films, system.shape, force, pressure);
    for (double& each : pressure) each /= -2;
    const FilmMotion motion = system.motion(pressure, delta);
    fit_velocities(system.films, system.shape, motion.flux(), still, u);
    double size = 0;
    for (const Vec3& each : u) size += each.squaredNorm();
    for (std::size_t v = 0; v < n; ++v) y[v] = u[v] / std::sqrt(size);
    square = std::sqrt(size);
  }
  EXPECT_LT(step, 2 / std::sqrt(square));
  EXPECT_GT(step, 1.3 / std::sqrt(square));
}

TEST(StableStep, ResolvesHowEdgesChange) {
  test::FilmSystem system(icosphere(1));
  std::vector<Vec3> u(system.x);
  for (Vec3& each : u) each *= 4;  // every edge grows by four times its length in a unit of time
  EXPECT_NEAR(resolved_step(system.films, system.x, u), 0.25, 1e-12);
  std::ranges::fill(u, Vec3(1, 2, 3));
  EXPECT_EQ(resolved_step(system.films, system.x, u), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace foamsim
