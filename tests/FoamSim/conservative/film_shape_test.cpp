#include "FoamSim/conservative/film_shape.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "FoamSim/scenes/shapes/double_bubble.h"
#include "tests/FoamSim/conservative/film_system.h"

namespace foamsim {
namespace {

using lostopos::Vec3;

// A Plateau border whose films all but lie in one plane.
test::FilmSystem flattened() {
  test::FilmSystem system(double_bubble(8));
  for (Vec3& x : system.x) x.x() *= 0.02;
  system.shape.update(system.films, system.x);
  return system;
}

// Where this was not bounded, foams without viscosity broke up.
TEST(FitVelocities, ThrowsNoVertexAlongDirectionsThatItBarelySees) {
  const test::FilmSystem system = flattened();
  const std::vector<double> flux = system.random_phi(5);
  const std::vector<Vec3> still(system.x.size(), Vec3::Zero());
  std::vector<Vec3> u(system.x.size());
  fit_velocities(system.films, system.shape, flux, still, u);
  std::size_t borders = 0;
  for (std::size_t v = 0; v < u.size(); ++v) {
    double size = 0, largest = 0;
    for (std::size_t e = system.films.first_entry[v]; e < system.films.first_entry[v + 1]; ++e) {
      size += flux[e] * flux[e];
      largest = std::max(largest, system.shape.region_gradient[e].norm());
    }
    EXPECT_LE(u[v].norm() * largest * weak_singular_value, 1.001 * std::sqrt(size)) << v;
    borders += system.films.first_entry[v + 1] - system.films.first_entry[v] > 2 ? 1 : 0;
  }
  EXPECT_GT(borders, 0U);
}

// F·u of the velocities of fluxes is P·f of the pressures of forces, there too.
TEST(FitVelocities, IsTheAdjointOfBalance) {
  const test::FilmSystem system = flattened();
  const std::vector<double> flux = system.random_phi(6);
  const std::vector<Vec3> still(system.x.size(), Vec3::Zero()), force(system.x.begin(), system.x.end());
  std::vector<Vec3> u(system.x.size());
  std::vector<double> pressure(flux.size());
  fit_velocities(system.films, system.shape, flux, still, u);
  balance(system.films, system.shape, force, pressure);
  double of_velocities = 0, of_pressures = 0, scale = 0;
  for (std::size_t v = 0; v < u.size(); ++v) of_velocities += force[v].dot(u[v]);
  for (std::size_t e = 0; e < flux.size(); ++e) {
    of_pressures += pressure[e] * flux[e];
    scale += std::abs(pressure[e] * flux[e]);
  }
  EXPECT_NEAR(of_velocities, of_pressures, 1e-12 * scale);
}

}  // namespace
}  // namespace foamsim
