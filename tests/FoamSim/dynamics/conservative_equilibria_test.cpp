// Where films under the conservative dynamics come to rest, and how they move about that: closed forms, impulse, and
// the spectrum of small motions.

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <complex>
#include <cstdio>
#include <numbers>
#include <optional>

#include "FoamSim/conservative/potential.h"
#include "FoamSim/scenes/methods.h"
#include "FoamSim/scenes/scene.h"
#include "FoamSim/scenes/shapes/double_bubble.h"
#include "FoamSim/scenes/shapes/exact_double_bubble.h"
#include "FoamSim/sheet/area_gradient.h"
#include "FoamSim/studies/stability/shapes/border_edits.h"
#include "LosTopos/mesh/measures.h"
#include "tests/FoamSim/conservative/film_system.h"

namespace foamsim {
namespace {

using lostopos::Edge;
using lostopos::Region;
using lostopos::SurfaceMesh;
using lostopos::Triangle;
using lostopos::Vec3;
using lostopos::Vertex;

using Assignments = std::vector<std::string>;

Scene conservative(const std::string& name, const Assignments& assignments) {
  Scene scene = built_in_scene(name);
  choose_method(scene.options, conservative_method, "test");
  scene.options.set_text("dt", "auto", "test");
  for (const std::string& assignment : assignments) scene.options.set_assignment(assignment, "test");
  return scene;
}

const Assignments soon_at_rest{"effects=surface_tension,volumes,damping", "damping=0.02", "viscosity=0.1"};

Simulation simulated(SurfaceMesh mesh, const Assignments& assignments) {
  const double resolution = lostopos::mean_edge_length(mesh);
  return make_simulation(conservative("doublebubble", assignments), std::move(mesh), resolution, {});
}

void run_until(Simulation& simulation, double time) {
  while (simulation.time() < time) simulation.step();
}

// Pressures of all bubbles above the air's: those with which Σ_r P_r ∂V_r/∂x is nearest to the gradient of the energy.
std::vector<double> pressures(const test::FilmSystem& system, const std::vector<Vec3>& force, std::size_t bubbles) {
  const auto n = static_cast<Eigen::Index>(bubbles);
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(n);
  for (std::size_t v = 0; v < system.films.vertex_slots(); ++v)
    for (std::uint32_t e = system.films.first_entry[v]; e < system.films.first_entry[v + 1]; ++e) {
      const auto r = static_cast<Eigen::Index>(system.films.regions[e].index()) - 1;
      if (r < 0) continue;
      right[r] += system.shape.region_gradient[e].dot(force[v]);
      for (std::uint32_t f = system.films.first_entry[v]; f < system.films.first_entry[v + 1]; ++f)
        if (const auto s = static_cast<Eigen::Index>(system.films.regions[f].index()) - 1; s >= 0)
          matrix(r, s) += system.shape.region_gradient[e].dot(system.shape.region_gradient[f]);
    }
  const Eigen::VectorXd solution = matrix.ldlt().solve(right);
  return {solution.begin(), solution.end()};
}

std::vector<double> pressures(const Simulation& simulation, std::size_t bubbles) {
  const test::FilmSystem system(simulation.mesh());
  std::vector<Vec3> force(system.x.size(), Vec3::Zero());
  add_area_gradient(simulation.mesh(), {}, system.x, 4, force);
  return pressures(system, force, bubbles);
}

void expect_closed_form(double ratio, long segments) {
  const double volume = 4 * std::numbers::pi / 3;
  SurfaceMesh mesh = exact_double_bubble(double_bubble_equilibrium(volume, ratio * volume), segments);
  add_noise(mesh, 0.01, 3);
  Simulation simulation = simulated(std::move(mesh), soon_at_rest);
  run_until(simulation, 3);
  const auto volumes = lostopos::region_volumes(simulation.mesh());
  const DoubleBubbleEquilibrium exact = double_bubble_equilibrium(volumes[1].volume, volumes[2].volume);
  const std::vector<double> found = pressures(simulation, 2);
  for (std::size_t b = 0; b < 2; ++b) {
    const double error = found[b] / exact.pressure(b, 4) - 1;
    std::printf("volumes 1 and %g, %ld segments, %zu triangles: pressure of bubble %zu off by %.4f%%\n", ratio,
                segments, simulation.mesh().triangle_count(), b + 1, 100 * error);
    EXPECT_LT(std::abs(error), 1e-3) << ratio;
  }
}

TEST(ConservativeRest, TwoBubblesHaveThePressuresOfTheClosedForm) {
  expect_closed_form(1, 36);
  expect_closed_form(2, 36);
}

// Three bubbles about the z axis: a ball cut by three half planes. `n` parallels, `m` (a multiple of 3) meridians.
SurfaceMesh cut_ball(long n, long m) {
  SurfaceMesh mesh;
  const auto at = [n](double radius, long i, double angle) {
    const double polar = std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
    return Vec3(radius * std::sin(polar) * std::cos(angle), radius * std::sin(polar) * std::sin(angle),
                std::cos(polar));
  };
  const long third = m / 3, half = std::max(2L, n / 3);
  const Vertex north = mesh.add_vertex(at(0, 0, 0)), south = mesh.add_vertex(at(0, n, 0));
  std::vector<Vertex> axis(static_cast<std::size_t>(n + 1), north);
  axis.back() = south;
  for (long i = 1; i < n; ++i) axis[static_cast<std::size_t>(i)] = mesh.add_vertex(at(0, i, 0));
  std::vector<std::vector<Vertex>> outer;
  for (long j = 0; j < m; ++j) {
    outer.emplace_back(axis.size(), north);
    outer.back().back() = south;
    for (long i = 1; i < n; ++i)
      outer.back()[static_cast<std::size_t>(i)] =
          mesh.add_vertex(at(1, i, 2 * std::numbers::pi * static_cast<double>(j) / static_cast<double>(m)));
  }
  // Between two lines from pole to pole.
  const auto strip = [&](const std::vector<Vertex>& a, const std::vector<Vertex>& b, lostopos::Labels labels) {
    for (std::size_t i = 0; i + 1 < a.size(); ++i) {
      if (i > 0) mesh.add_triangle(a[i], a[i + 1], b[i], labels);
      if (i + 2 < a.size()) mesh.add_triangle(a[i + 1], b[i + 1], b[i], labels);
    }
  };
  const auto wedge = [third](long j) { return Region(static_cast<std::uint32_t>(j / third + 1)); };
  for (long j = 0; j < m; ++j)
    strip(outer[static_cast<std::size_t>(j)], outer[static_cast<std::size_t>((j + 1) % m)], {wedge(j), lostopos::air});
  for (long w = 0; w < 3; ++w) {
    std::vector<Vertex> line = axis;
    const double angle = 2 * std::numbers::pi * static_cast<double>(w) / 3;
    for (long k = 1; k <= half; ++k) {
      std::vector<Vertex> next = outer[static_cast<std::size_t>(w * third)];
      if (k < half)
        for (long i = 1; i < n; ++i)
          next[static_cast<std::size_t>(i)] =
              mesh.add_vertex(at(static_cast<double>(k) / static_cast<double>(half), i, angle));
      strip(line, next, {wedge(w * third), wedge((w + 2) % 3 * third)});
      line = std::move(next);
    }
  }
  return mesh;
}

// Volume of one of three equal bubbles whose outer films have the radius 1: they meet each other and the flat walls at
// 120°, so that a centre is half a radius from both walls, 1/√3 from the axis.
double volume_of_three_bubbles() {
  constexpr int n = 1500;
  const double d = 1 / std::numbers::sqrt3;
  double volume = 0;
  for (int k = 0; k < n; ++k) {
    const double z = -1 + (k + 0.5) * 2 / n, square = 1 - z * z;
    for (int j = 0; j < n; ++j) {
      const double angle = std::numbers::pi / 3 * (-1 + (j + 0.5) * 2 / n), s = d * std::sin(angle);
      if (s * s > square) continue;
      const double root = std::sqrt(square - s * s), far = d * std::cos(angle) + root,
                   near = std::max(0.0, d * std::cos(angle) - root);
      if (far > 0) volume += (far * far - near * near) / 2 * (2 * std::numbers::pi / 3 / n) * (2.0 / n);
    }
  }
  return volume;
}

TEST(ConservativeRest, ThreeBubblesHaveThePressureOfTheClosedForm) {
  Simulation simulation = simulated(cut_ball(25, 48), soon_at_rest);
  run_until(simulation, 2.5);
  const auto volumes = lostopos::region_volumes(simulation.mesh());
  const double mean = (volumes[1].volume + volumes[2].volume + volumes[3].volume) / 3;
  const double exact = 2 * 4.0 / std::cbrt(mean / volume_of_three_bubbles());
  for (const double found : pressures(simulation, 3)) {
    std::printf("three bubbles, %zu triangles: pressure off by %.4f%%\n", simulation.mesh().triangle_count(),
                100 * (found / exact - 1));
    EXPECT_LT(std::abs(found / exact - 1), 1e-3);
  }
}

Vertex plateau_vertex(const Simulation& simulation) {
  std::optional<Vertex> found;
  for (Vertex v : simulation.mesh().vertices())
    if (!lostopos::is_held(simulation.held()[v.index()]) && simulation.geometry().regions(v).size() >= 4) {
      EXPECT_FALSE(found) << "there is one";
      found = v;
    }
  return found.value();
}

// Angles between the borders' first edges, degrees.
std::vector<double> border_angles(const Simulation& simulation) {
  const Vertex middle = plateau_vertex(simulation);
  std::vector<Vec3> along;
  for (Edge e : simulation.mesh().edges(middle))
    if (simulation.mesh().triangles(e).size() >= 3) {
      const auto& ends = simulation.mesh().vertices(e);
      const Vertex other = ends[0] == middle ? ends[1] : ends[0];
      along.push_back((simulation.mesh().position(other) - simulation.mesh().position(middle)).normalized());
    }
  EXPECT_EQ(along.size(), 4U);
  std::vector<double> angles;
  for (std::size_t i = 0; i < along.size(); ++i)
    for (std::size_t j = i + 1; j < along.size(); ++j)
      angles.push_back(std::acos(along[i].dot(along[j])) * 180 / std::numbers::pi);
  return angles;
}

// The start's vertex is off the middle, so that the triangles around it are of all sizes.
TEST(ConservativeRest, PlateauVertexFindsTheTetrahedralAngleOnAnUnevenMesh) {
  for (const char* remeshing : {"true", "false"}) {
    Assignments assignments = soon_at_rest;
    assignments.insert(assignments.end(), {"n=3", "displacement=0.15", std::string("remeshing.enabled=") + remeshing});
    Simulation simulation = make_simulation(conservative("quadjunction-frame", assignments));
    run_until(simulation, 6);
    double worst = 0;
    for (const double angle : border_angles(simulation)) worst = std::max(worst, std::abs(angle - 109.4712206));
    std::printf("Plateau vertex, remeshing %s: largest error %.4f degrees\n", remeshing, worst);
    EXPECT_LT(worst, 0.05);
  }
}

// Potentials whose flux is that of all vertices going with `velocity`.
std::vector<double> translation(const Simulation& simulation, const Vec3& velocity) {
  const test::FilmSystem system(simulation.mesh());
  const auto n = static_cast<Eigen::Index>(system.films.entries());
  Eigen::MatrixXd matrix(n, n);
  Eigen::VectorXd flux(n);
  for (Eigen::Index e = 0; e < n; ++e) {
    const auto entry = static_cast<std::size_t>(e);
    std::vector<double> unit(system.films.entries(), 0.0);
    unit[entry] = 1;
    const FilmMotion motion = system.motion(unit, simulation.delta());
    for (Eigen::Index i = 0; i < n; ++i) matrix(i, e) = motion.flux()[static_cast<std::size_t>(i)];
    flux[e] = system.shape.region_gradient[entry].dot(velocity);
  }
  // Constants at a vertex move nothing.
  matrix -= 1e-9 * matrix.diagonal().cwiseAbs().maxCoeff() * Eigen::MatrixXd::Identity(n, n);
  const Eigen::VectorXd phi = matrix.ldlt().solve(flux);
  return {phi.begin(), phi.end()};
}

TEST(ConservativeMotion, KeepsTheImpulseThatADoubleBubbleIsGiven) {
  const double volume = 4 * std::numbers::pi / 3;
  Simulation simulation =
      simulated(exact_double_bubble(double_bubble_equilibrium(volume, volume), 36), {"viscosity=0"});
  const std::vector<double> phi = translation(simulation, Vec3(0, 0.2, 0));
  put_circulation(test::FilmSystem(simulation.mesh()).films, phi, simulation.circulation());
  const Vec3 from = lostopos::surface_centroid(simulation.mesh());
  StepReport first = simulation.step();
  double energy_change = 0, impulse_change = 0;
  const double energy = first.kinetic_energy + first.potential_energy;
  while (simulation.time() < 4) {
    const StepReport report = simulation.step();
    energy_change = std::max(energy_change, std::abs(report.kinetic_energy + report.potential_energy - energy));
    impulse_change = std::max(impulse_change, (report.impulse - first.impulse).norm());
  }
  const Vec3 way = lostopos::surface_centroid(simulation.mesh()) - from;
  std::printf("speed %.4f %.4f %.4f, K + E within %.4f%%, impulse within %.4f%%\n", way.x() / 4, way.y() / 4,
              way.z() / 4, 100 * energy_change / energy, 100 * impulse_change / first.impulse.norm());
  EXPECT_LT(energy_change, 1e-3 * energy);
  EXPECT_LT(impulse_change, 1e-2 * first.impulse.norm());
  EXPECT_NEAR(way.y() / 4, 0.2, 0.03);
}

// Eigenvalues of M in ẍ = M x for small motions about rest.
Eigen::VectorXcd spectrum(const Simulation& simulation) {
  test::FilmSystem system(simulation);
  const std::size_t slots = system.films.vertex_slots();
  const auto n = static_cast<Eigen::Index>(3 * slots);
  const auto accelerate = [&](std::vector<double>& phi_rate) {
    FilmShape shape;
    shape.update(system.films, system.x);
    std::vector<Vec3> force(slots, Vec3::Zero());
    add_area_gradient(simulation.mesh(), {}, system.x, 4, force);
    phi_rate.resize(system.films.entries());
    balance(system.films, shape, force, phi_rate);
    for (double& rate : phi_rate) rate /= 2;
  };
  const std::vector<Vec3> still(slots, Vec3::Zero());
  std::vector<Vec3> u(slots);
  std::vector<double> more, less;
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    constexpr double step = 1e-5;
    const auto v = static_cast<std::size_t>(i / 3);
    if (system.films.held[v] != 0) continue;
    double& x = system.x[v][i % 3];
    const double here = x;
    x = here + step;
    accelerate(more);
    x = here - step;
    accelerate(less);
    x = here;
    for (std::size_t e = 0; e < more.size(); ++e) more[e] = (more[e] - less[e]) / (2 * step);
    const FilmMotion motion = system.motion(more, simulation.delta(), simulation.delta());
    fit_velocities(system.films, system.shape, motion.flux(), still, u);
    for (Eigen::Index j = 0; j < n; ++j) matrix(j, i) = u[static_cast<std::size_t>(j / 3)][j % 3];
  }
  return Eigen::EigenSolver<Eigen::MatrixXd>(matrix, false).eigenvalues();
}

// Minus M is a positive matrix times the area's second derivative: no eigenvalue but real ones that are not positive,
// whatever the mesh. (Flat films pull nowhere along themselves, so that the mesh is at rest, too; where it is not, its
// pull along the films turns with their normals.)
TEST(ConservativeMotion, HasNoGrowingModeAboutRest) {
  Assignments assignments = soon_at_rest;
  assignments.insert(assignments.end(), {"n=2", "displacement=0.2"});
  Simulation simulation = make_simulation(conservative("quadjunction-frame", assignments));
  run_until(simulation, 12);
  double fastest = 0, growth = 0;
  for (const std::complex<double>& value : spectrum(simulation)) {
    const std::complex<double> rate = std::sqrt(value);
    fastest = std::max(fastest, std::abs(rate));
    growth = std::max(growth, std::abs(rate.real()));
  }
  std::printf("fastest %.4f, growth %.2e of it\n", fastest, growth / fastest);
  EXPECT_GT(fastest, 1);
  EXPECT_LT(growth, 1e-4 * fastest);
}

// A cylinder of radius 1 and length 1 between rings that are held: the catenoid r = c cosh(y / c), r(1/2) = 1. The
// scene names no constraint; free edges are held all the same.
TEST(ConservativeRest, OfABarrelIsACatenoid) {
  Simulation simulation = make_simulation(
      conservative("barrel", {"n=32", "m=11", "effects=surface_tension,damping", "damping=0.02", "viscosity=0.1"}));
  std::vector<Vec3> start(simulation.mesh().positions().begin(), simulation.mesh().positions().end());
  run_until(simulation, 3);
  constexpr double neck = 0.8483379380;
  for (Vertex v : simulation.mesh().vertices()) {
    const Vec3 x = simulation.mesh().position(v);
    if (std::abs(std::abs(start[v.index()].y()) - 0.5) < 1e-9) {
      EXPECT_EQ(x, start[v.index()]);
    } else {
      EXPECT_NEAR(std::hypot(x.x(), x.z()), neck * std::cosh(x.y() / neck), 0.01);
    }
  }
}

}  // namespace
}  // namespace foamsim
