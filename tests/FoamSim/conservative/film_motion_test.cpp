// The mechanics: what one half of the scheme says of energy is what the other half does.

#include "FoamSim/conservative/film_motion.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <map>

#include "FoamSim/scenes/shapes/double_bubble.h"
#include "FoamSim/scenes/shapes/junction_frames.h"
#include "FoamSim/scenes/shapes/solids.h"
#include "FoamSim/sheet/area_gradient.h"
#include "LosTopos/mesh/measures.h"
#include "LosTopos/shapes/voronoi_foam.h"
#include "tests/FoamSim/conservative/film_system.h"

namespace foamsim {
namespace {

using lostopos::Region;
using lostopos::SurfaceMesh;
using lostopos::Vec3;
using test::FilmSystem;

SurfaceMesh small_foam() {
  return lostopos::voronoi_foam({.cells = 6, .seed = 2, .subdivisions = 0});
}

struct Sample {
  const char* name;
  SurfaceMesh (*mesh)();
};

class FilmMechanics : public testing::TestWithParam<Sample> {};

constexpr double delta = 0.15, near_delta = 0.1;

// K as a matrix in φ: column e is −2 f for a unit potential of entry e.
Eigen::MatrixXd energy_matrix(const FilmSystem& system) {
  const auto n = static_cast<Eigen::Index>(system.films.entries());
  Eigen::MatrixXd matrix(n, n);
  for (Eigen::Index e = 0; e < n; ++e) {
    std::vector<double> unit(system.films.entries(), 0.0);
    unit[static_cast<std::size_t>(e)] = 1;
    const FilmMotion motion = system.motion(unit, delta, near_delta);
    for (Eigen::Index i = 0; i < n; ++i) matrix(i, e) = -2 * motion.flux()[static_cast<std::size_t>(i)];
  }
  return matrix;
}

TEST_P(FilmMechanics, EnergyIsSymmetricAndPositive) {
  const FilmSystem system(GetParam().mesh());
  const Eigen::MatrixXd m = energy_matrix(system);
  const double size = m.norm();
  EXPECT_LT((m - m.transpose()).norm(), 1e-13 * size);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(m);
  EXPECT_GT(solver.eigenvalues().minCoeff(), -1e-13 * size);
}

TEST_P(FilmMechanics, FluxIsMinusHalfTheSlopeOfEnergy) {
  const FilmSystem system(GetParam().mesh());
  std::vector<double> phi = system.random_phi();
  const FilmMotion motion = system.motion(phi, delta, near_delta);
  double product = 0;
  for (std::size_t e = 0; e < phi.size(); ++e) product -= phi[e] * motion.flux()[e];
  EXPECT_NEAR(product, motion.kinetic_energy(), 1e-12 * product) << "K = -sum of phi f";
  for (std::size_t e = 0; e < phi.size(); e += 17) {
    constexpr double step = 1e-3;  // K is quadratic: a difference of any size is exact
    const double here = phi[e];
    phi[e] = here + step;
    const double more = system.motion(phi, delta, near_delta).kinetic_energy();
    phi[e] = here - step;
    const double less = system.motion(phi, delta, near_delta).kinetic_energy();
    phi[e] = here;
    EXPECT_NEAR((more - less) / (2 * step), -2 * motion.flux()[e], 1e-9 * motion.kinetic_energy());
  }
}

TEST_P(FilmMechanics, ClosedRegionsKeepTheirVolumes) {
  const SurfaceMesh mesh = GetParam().mesh();
  const FilmSystem system(mesh);
  const FilmMotion motion = system.motion(system.random_phi(), delta, near_delta);
  std::map<Region, double> sums, sizes;
  for (std::size_t e = 0; e < system.films.entries(); ++e) {
    sums[system.films.regions[e]] += motion.flux()[e];
    sizes[system.films.regions[e]] += std::abs(motion.flux()[e]);
  }
  for (const auto& [region, volume] : lostopos::closed_region_volumes(mesh))
    EXPECT_LT(std::abs(sums[region]), 1e-13 * sizes[region]) << region.index();
}

// h with no part along the films: the work of h on normal velocities is what K changes by.
TEST_P(FilmMechanics, InertiaDoesTheWorkThatEnergyTakes) {
  FilmSystem system(GetParam().mesh());
  const std::vector<double> phi = system.random_phi();
  const FilmMotion motion = system.motion(phi, delta, near_delta);
  const std::vector<Vec3> still(system.x.size(), Vec3::Zero());
  std::vector<Vec3> u(system.x.size()), force(system.x.size(), Vec3::Zero());
  fit_velocities(system.films, system.shape, motion.flux(), still, u);
  motion.add_inertia(system.films, system.shape, system.x, u, force);
  double work = 0, size = 0;
  for (std::size_t v = 0; v < u.size(); ++v) {
    work += force[v].dot(u[v]);
    size += force[v].norm() * u[v].norm();
  }
  const std::vector<Vec3> start = system.x;
  double speed = 0;
  for (const Vec3& each : u) speed = std::max(speed, each.norm());
  const double step = 1e-5 / speed;
  const auto energy = [&](double time) {
    for (std::size_t v = 0; v < u.size(); ++v) system.x[v] = start[v] + time * u[v];
    return system.motion(phi, delta, near_delta).kinetic_energy();
  };
  const double slope = (energy(step) - energy(-step)) / (2 * step);
  EXPECT_NEAR(work, slope, 1e-6 * size);
}

TEST_P(FilmMechanics, PressuresThatBalanceWorkAsTheirForce) {
  const FilmSystem system(GetParam().mesh());
  const FilmMotion motion = system.motion(system.random_phi(), delta);
  std::vector<Vec3> force(system.x.size(), Vec3::Zero());
  const SurfaceMesh mesh = GetParam().mesh();
  add_area_gradient(mesh, {}, system.x, 4, force);
  std::vector<double> pressure(system.films.entries());
  balance(system.films, system.shape, force, pressure);
  const std::vector<Vec3> still(system.x.size(), Vec3::Zero());
  std::vector<Vec3> u(system.x.size());
  fit_velocities(system.films, system.shape, motion.flux(), still, u);
  // Power of the force on the air's motion, both ways round: P·f = F·u, the adjoint that energy needs.
  double by_pressure = 0, by_force = 0, size = 0;
  for (std::size_t e = 0; e < pressure.size(); ++e) by_pressure += pressure[e] * motion.flux()[e];
  for (std::size_t v = 0; v < u.size(); ++v) {
    by_force += force[v].dot(u[v]);
    size += force[v].norm() * u[v].norm();
  }
  EXPECT_NEAR(by_pressure, by_force, 1e-11 * size);
}

INSTANTIATE_TEST_SUITE_P(Meshes, FilmMechanics,
                         testing::Values(Sample{"sphere", [] { return icosphere(1); }},
                                         Sample{"double_bubble", [] { return double_bubble(8); }},
                                         Sample{"quadjunction", [] { return quad_junction_frame(2, 0.2); }},
                                         Sample{"foam", small_foam}),
                         [](const auto& sample) { return sample.param.name; });

TEST(AreaGradient, IsTheSlopeOfTheArea) {
  const SurfaceMesh mesh = double_bubble(8);
  std::vector<Vec3> x(mesh.positions().begin(), mesh.positions().end()), gradient(x.size(), Vec3::Zero());
  add_area_gradient(mesh, {}, x, 1, gradient);
  for (std::size_t v = 0; v < x.size(); v += 13)
    for (int axis = 0; axis < 3; ++axis) {
      constexpr double step = 1e-5;
      const double here = x[v][axis];
      x[v][axis] = here + step;
      const double more = film_area(mesh, {}, x);
      x[v][axis] = here - step;
      const double less = film_area(mesh, {}, x);
      x[v][axis] = here;
      EXPECT_NEAR((more - less) / (2 * step), gradient[v][axis], 1e-8);
    }
}

}  // namespace
}  // namespace foamsim
