// The integrators that take tension implicitly: their equation, its derivatives, its solution.

#include "FoamSim/dynamics/implicit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "Base/error.h"
#include "FoamSim/dynamics/implicit_tension.h"
#include "FoamSim/dynamics/simulation.h"
#include "FoamSim/dynamics/vortex_sheet.h"
#include "FoamSim/effects/surface_tension.h"
#include "FoamSim/scenes/shapes/double_bubble.h"
#include "FoamSim/scenes/shapes/solids.h"
#include "FoamSim/sheet/velocity/direct.h"
#include "LosTopos/shapes/solids.h"
#include "tests/FoamSim/film_parts.h"

namespace foamsim {
namespace {

using lostopos::SurfaceMesh;
using lostopos::Vec3;

Eigen::VectorXd random_vector(Eigen::Index size, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> value(-1, 1);
  Eigen::VectorXd v(size);
  for (double& each : v) each = value(random);
  return v;
}

// A surface with some circulation, as an integrator sees it.
struct Films {
  explicit Films(SurfaceMesh surface, double dt)
      : mesh(std::move(surface)), circulation(mesh), held(mesh.vertex_slots()) {
    geometry.update(mesh);
    for (lostopos::Vertex v : mesh.vertices())
      for (PairCirculation& entry : circulation.at(v))
        entry.value = 0.3 * std::sin(3.0 * mesh.position(v).x() + v.index());
    held[2] = lostopos::Hold::all;
    step.emplace(EffectStep{mesh, geometry, 0, dt, held});
    kick.emplace(CirculationKick{*step, circulation, 1.3, 0.2,
                                 [this](std::span<const SheetTriangle> sheet, std::span<Vec3> velocity) {
                                   sum.evaluate(sheet, mesh.positions(), mesh.positions(), 0.2, velocity);
                                 }});
  }
  SurfaceMesh mesh;
  CirculationField circulation;
  SurfaceGeometry geometry;
  std::vector<lostopos::Hold> held;
  SheetVelocity sum{std::make_unique<DirectBiotSavart>()};
  std::optional<EffectStep> step;
  std::optional<CirculationKick> kick;
};

TEST(SineCurvatureTest, OfABallIsTwiceThatOfTheExplicitScheme) {
  const SurfaceMesh mesh = lostopos::icosphere(4);
  SurfaceGeometry geometry;
  geometry.update(mesh);
  std::vector<double> curvature;
  SineCurvature(mesh, geometry).evaluate(mesh.positions(), curvature);
  double mean = 0;
  for (lostopos::Vertex v : mesh.vertices()) {
    const auto regions = geometry.regions(v);
    ASSERT_EQ(regions.size(), 2U);
    EXPECT_NEAR(curvature[geometry.first_entry(v)], -curvature[geometry.first_entry(v) + 1], 1e-9);
    mean += curvature[geometry.first_entry(v) + 1] / static_cast<double>(mesh.vertex_count());
  }
  EXPECT_NEAR(mean, 4, 0.02) << "2 · 2/R";
}

TEST(SineCurvatureTest, HasTheDerivativeOfFiniteDifferences) {
  const SurfaceMesh mesh = double_bubble(8);
  SurfaceGeometry geometry;
  geometry.update(mesh);
  const SineCurvature curvature(mesh, geometry);
  std::vector<Vec3> x(mesh.positions().begin(), mesh.positions().end());
  std::mt19937 random(3);
  std::uniform_real_distribution<double> value(-0.02, 0.02);
  for (Vec3& each : x) each += Vec3(value(random), value(random), value(random));
  const auto derivative = curvature.derivative(x);
  const Eigen::VectorXd along = random_vector(derivative.cols(), 4);
  const Eigen::VectorXd exact = derivative * along;
  constexpr double h = 1e-6;
  std::vector<double> before, after;
  std::vector<Vec3> moved = x;
  for (std::size_t v = 0; v < x.size(); ++v) moved[v] = x[v] - h * along.segment<3>(static_cast<Eigen::Index>(3 * v));
  curvature.evaluate(moved, before);
  for (std::size_t v = 0; v < x.size(); ++v) moved[v] = x[v] + h * along.segment<3>(static_cast<Eigen::Index>(3 * v));
  curvature.evaluate(moved, after);
  for (std::size_t e = 0; e < before.size(); ++e)
    EXPECT_NEAR((after[e] - before[e]) / (2 * h), exact[static_cast<Eigen::Index>(e)], 1e-6 * exact.norm()) << e;
}

TEST(ImplicitTensionTest, HasTheDerivativeOfFiniteDifferences) {
  Films films(double_bubble(8), 0.05);
  ImplicitTension equation(*films.kick);
  const Eigen::VectorXd change = 0.1 * random_vector(equation.size(), 1), along = random_vector(equation.size(), 2);
  constexpr double h = 1e-6;
  const Eigen::VectorXd slope =
      (equation.residual(change + h * along) - equation.residual(change - h * along)) / (2 * h);
  equation.residual(change);
  equation.linearise();
  const Eigen::VectorXd exact = equation.apply(along);
  EXPECT_LT((exact - slope).norm(), 1e-6 * (exact - along).norm());
  EXPECT_GT((exact - along).norm(), 0.1 * along.norm()) << "too weak a test";
}

TEST(ImplicitTensionTest, HasATransposeAndRowsThatBelongToIt) {
  Films films(double_bubble(8), 0.05);
  ImplicitTension equation(*films.kick);
  equation.residual(Eigen::VectorXd::Zero(equation.size()));
  equation.linearise();
  const Eigen::VectorXd v = random_vector(equation.size(), 1), w = random_vector(equation.size(), 2);
  EXPECT_NEAR(w.dot(equation.apply(v)), v.dot(equation.apply_transposed(w)), 1e-10 * v.norm() * w.norm());
  const Eigen::VectorXd squares = equation.squared_rows();
  for (Eigen::Index i = 0; i < equation.size(); i += 7) {
    const Eigen::VectorXd row = equation.apply_transposed(Eigen::VectorXd::Unit(equation.size(), i));
    EXPECT_NEAR(squares[i], row.squaredNorm(), 1e-10 * squares[i]) << i;
  }
}

TEST(ImplicitTensionTest, LeavesHeldVerticesAlone) {
  Films films(double_bubble(8), 0.05);
  const VertexCirculation before(films.circulation.at(lostopos::Vertex(2)).begin(),
                                 films.circulation.at(lostopos::Vertex(2)).end());
  Implicit().kick(*films.kick);
  for (std::size_t i = 0; i < before.size(); ++i)
    EXPECT_EQ(films.circulation.at(lostopos::Vertex(2))[i].value, before[i].value);
}

Eigen::VectorXd all_values(const Films& films) {
  std::vector<double> values;
  for (lostopos::Vertex v : films.mesh.vertices())
    for (const PairCirculation& entry : films.circulation.at(v)) values.push_back(entry.value);
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

TEST(ImplicitIntegrator, LeavesNoResidual) {
  for (double dt : {0.01, 0.1}) {
    Films films(double_bubble(12), dt), start(double_bubble(12), dt);
    const long rounds = Implicit().kick(*films.kick);
    EXPECT_LE(rounds, 12) << dt;
    ImplicitTension equation(*start.kick);
    const Eigen::VectorXd change = all_values(films) - all_values(start);
    EXPECT_LT(equation.residual(change).norm(), implicit_tolerance * (1 + change.norm())) << dt;
    EXPECT_GT(change.norm(), 0.1) << dt;
  }
}

TEST(ImplicitIntegrator, KicksTwiceAsMuchAsTheExplicitOneInShortSteps) {
  constexpr double dt = 1e-5;
  Films implicit(lostopos::icosphere(3), dt), explicitly(lostopos::icosphere(3), dt);
  const Eigen::VectorXd start = all_values(implicit);
  Implicit().kick(*implicit.kick);
  test::tension(1.3, "naive")->update_circulation(*explicitly.step, explicitly.circulation);
  const Eigen::VectorXd one = all_values(implicit) - start, other = all_values(explicitly) - start;
  EXPECT_LT((one - 2 * other).norm(), 0.01 * one.norm()) << "the sine is not the angle, and a step is not nothing";
}

// Of an ellipsoid that is let go, its largest area within some steps, and the last one; over that of the start.
struct Areas {
  double largest = 0, last = 0;
};
Areas areas_of_run(const char* integrator, double dt, int steps) {
  SimulationOptions options{.dt = dt};
  options.tracker.collisions = false;
  options.tracker.largest_motion = 1e9;
  auto effect = takes_tension(integrator) ? std::make_unique<SurfaceTension>(1, nullptr) : test::tension(1, "naive");
  Simulation simulation(ellipsoid(2, Vec3(0.4, 1, 1)), options, test::parts(std::move(effect), integrator));
  const double start = simulation.geometry().total_area();
  Areas areas;
  for (int i = 0; i < steps; ++i) {
    simulation.step();
    areas.last = simulation.geometry().total_area() / start;
    areas.largest = std::max(areas.largest, areas.last);
  }
  return areas;
}

TEST(ImplicitIntegrator, BearsStepsThatTheExplicitOneDoesNot) {
  const Areas explicitly = areas_of_run("euler", 0.2, 8), implicitly = areas_of_run("implicit", 0.2, 40);
  EXPECT_FALSE(explicitly.largest < 10);
  EXPECT_LT(implicitly.largest, 1.05);
  EXPECT_LT(implicitly.last, 1.0);
}

TEST(PositionBasedIntegrator, FindsWhatImplicitFindsWhereBothConverge) {
  constexpr double dt = 0.01;
  Films one(lostopos::icosphere(2), dt), other(lostopos::icosphere(2), dt);
  const Eigen::VectorXd start = all_values(one);
  const long rounds = Implicit().kick(*one.kick);
  const long projections = PositionBased().kick(*other.kick);
  EXPECT_LT(rounds, 12);
  EXPECT_LT(projections, most_implicit_rounds);
  EXPECT_LT((all_values(one) - all_values(other)).norm(), 1e-6);
  EXPECT_GT((all_values(one) - start).norm(), 0.1);
}

TEST(PositionBasedIntegrator, IsForSmallSurfacesOnly) {
  Films films(lostopos::icosphere(5), 0.01);
  EXPECT_THROW(PositionBased().kick(*films.kick), base::InputError);
}

}  // namespace
}  // namespace foamsim
