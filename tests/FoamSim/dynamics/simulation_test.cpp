#include "FoamSim/dynamics/simulation.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "FoamSim/effects/damping.h"
#include "FoamSim/scenes/shapes/double_bubble.h"
#include "FoamSim/scenes/shapes/solids.h"
#include "FoamSim/sheet/sheet_strength.h"
#include "FoamSim/sheet/sheet_velocity.h"
#include "FoamSim/sheet/velocity/registry.h"
#include "LosTopos/error.h"
#include "LosTopos/mesh/measures.h"
#include "tests/FoamSim/film_parts.h"

namespace foamsim {
namespace {

using lostopos::air;
using lostopos::Region;
using lostopos::SurfaceMesh;
using lostopos::Vec3;
using lostopos::Vertex;
using test::parts;
using test::tension;

SurfaceMesh dented_sphere(long n) {
  SurfaceMesh mesh = icosphere(n);
  perturb_with_mode(mesh, 2, 0.1);
  return mesh;
}

TEST(SimulationStep, EulerEvaluatesTheVelocityOnceAndRk4FourTimes) {
  for (const auto& [integrator, expected] : {std::pair("euler", 1L), std::pair("rk4", 4L)}) {
    Simulation simulation(double_bubble(8), {}, parts(tension(), integrator));
    for (int i = 0; i < 3; ++i) EXPECT_EQ(simulation.step().velocity_evaluations, expected);
  }
}

TEST(SimulationStep, CountsAndTimes) {
  Simulation simulation(double_bubble(8), {.dt = 0.02}, parts(tension()));
  const StepReport report = simulation.step();
  simulation.step();
  EXPECT_EQ(simulation.steps(), 2);
  EXPECT_DOUBLE_EQ(simulation.time(), 0.04);
  for (const char* stage : {"surface_tension", "velocity", "move", "geometry"})
    EXPECT_GT(report.times.seconds(stage), 0);
}

TEST(SimulationStep, IsCurvatureThenVelocityThenMotion) {
  // One Euler step by hand.
  SurfaceMesh mesh = dented_sphere(2);
  SurfaceGeometry geometry;
  geometry.update(mesh);
  CirculationField circulation(mesh);
  tension(2)->update_circulation({mesh, geometry, 0, 0.03}, circulation);
  std::vector<SheetTriangle> sheet;
  gather_sheet(mesh, circulation, sheet);
  std::vector<Vec3> u(mesh.vertex_slots());
  const double delta = 0.75 * geometry.mean_edge_length();
  SheetVelocity(make_biot_savart("direct")).evaluate(sheet, mesh.positions(), mesh.positions(), delta, u);

  Simulation simulation(dented_sphere(2), {.dt = 0.03}, parts(tension(2)));
  EXPECT_DOUBLE_EQ(simulation.delta(), delta);
  simulation.step();
  for (Vertex v : mesh.vertices())
    EXPECT_LT((simulation.mesh().position(v) - (mesh.position(v) + 0.03 * u[v.index()])).norm(), 1e-15);
}

TEST(SimulationOptionsTest, ResolutionAndDelta) {
  const double mean = lostopos::mean_edge_length(double_bubble(8));
  EXPECT_DOUBLE_EQ(Simulation(double_bubble(8), {}, parts()).resolution(), mean);
  EXPECT_DOUBLE_EQ(Simulation(double_bubble(8), {}, parts()).delta(), 0.75 * mean);
  EXPECT_DOUBLE_EQ(Simulation(double_bubble(8), {.resolution = 0.4}, parts()).delta(), 0.3);
  EXPECT_DOUBLE_EQ(Simulation(double_bubble(8), {.delta = 0.1, .resolution = 0.4}, parts()).delta(), 0.1);
}

TEST(SimulationOptionsTest, NonsenseIsRefused) {
  EXPECT_THROW(Simulation(SurfaceMesh(), {}, parts()), base::InputError);
  EXPECT_THROW(Simulation(icosphere(0), {.dt = 0}, parts()), base::InputError);
  EXPECT_THROW(Simulation(icosphere(0), {.dt = -1}, parts()), base::InputError);
  EXPECT_THROW(Simulation(icosphere(0), {.dt = std::numeric_limits<double>::quiet_NaN()}, parts()), base::InputError);
  EXPECT_THROW(Simulation(icosphere(0), {.delta = -1}, parts()), base::InputError);
  EXPECT_THROW(Simulation(icosphere(0), {.resolution = -1}, parts()), base::InputError);
}

TEST(SimulationAtRest, WithoutTensionNothingMoves) {
  Simulation simulation(double_bubble(8), {}, parts());
  const StepReport report = simulation.step();
  const SurfaceMesh start = double_bubble(8);
  for (Vertex v : start.vertices()) EXPECT_EQ(simulation.mesh().position(v), start.position(v));
  EXPECT_EQ(report.kinetic_energy, 0);
  EXPECT_EQ(report.impulse, Vec3(0, 0, 0));
}

TEST(SimulationMotion, ThatIsNotFiniteStopsWithTheSurfaceAsItWas) {
  Simulation simulation(dented_sphere(1), {}, parts(tension()));
  simulation.circulation().set(Vertex(3), {Region(1), air}, std::numeric_limits<double>::quiet_NaN());
  EXPECT_THROW(simulation.step(), lostopos::MotionError);
  const SurfaceMesh start = dented_sphere(1);
  for (Vertex v : start.vertices()) EXPECT_EQ(simulation.mesh().position(v), start.position(v));
  EXPECT_EQ(simulation.steps(), 0);
}

TEST(SimulationConservation, OfEnergyImpulseAndVolumeInALargeOscillation) {
  Simulation simulation(dented_sphere(3), {.dt = 0.01}, parts(tension(), "rk4"));
  const double volume = lostopos::region_volumes(simulation.mesh())[1].volume;
  double start = 0, peak_kinetic = 0, largest_change = 0, peak_impulse = 0, impulse_scale = 0;
  for (int i = 0; i < 180; ++i) {
    const StepReport report = simulation.step();
    const double energy = report.kinetic_energy + report.potential_energy;
    if (i == 0) start = energy;
    largest_change = std::max(largest_change, std::abs(energy - start));
    peak_kinetic = std::max(peak_kinetic, report.kinetic_energy);
    peak_impulse = std::max(peak_impulse, report.impulse.norm());
    impulse_scale = std::max(impulse_scale, report.impulse_scale);
  }
  EXPECT_LT(largest_change, 0.02 * peak_kinetic);
  EXPECT_LT(peak_impulse, 1e-3 * impulse_scale);
  EXPECT_NEAR(lostopos::region_volumes(simulation.mesh())[1].volume / volume, 1, 0.003);
}

TEST(SimulationConservation, ReportedEnergyIsSecondOrderInTheStep) {
  // Over the same time with half the step, the error that comes from the step falls to a quarter. What the triangles
  // lose is the same for both and drops out of the differences.
  auto energy_at_04 = [](double dt) {
    Simulation simulation(dented_sphere(2), {.dt = dt}, parts(tension(), "rk4"));
    // Take half of the first kick back, so that the start is at rest at time 0 for any dt.
    const EffectStep back{simulation.mesh(), simulation.geometry(), 0, -dt / 2};
    simulation.effects()[0]->update_circulation(back, simulation.circulation());
    StepReport report;
    for (long i = 0; i <= std::lround(0.4 / dt); ++i) report = simulation.step();
    return report.kinetic_energy + report.potential_energy;
  };
  const double coarse = energy_at_04(0.04), middle = energy_at_04(0.02), fine = energy_at_04(0.01);
  EXPECT_NEAR((coarse - middle) / (middle - fine), 4, 0.6);
}

TEST(SimulationDamping, TakesEnergyAway) {
  std::vector<std::unique_ptr<Effect>> effects;
  effects.push_back(tension());
  effects.push_back(std::make_unique<Damping>(0.1));
  Simulation simulation(dented_sphere(2), {.dt = 0.01}, parts(std::move(effects), "rk4"));
  const StepReport first = simulation.step();
  StepReport last;
  for (int i = 0; i < 300; ++i) last = simulation.step();
  EXPECT_LT(last.kinetic_energy + last.potential_energy, first.kinetic_energy + first.potential_energy - 0.1);
}

TEST(SimulationSymmetry, TurningTheSceneTurnsTheResult) {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.8, Vec3(1, -2, 3).normalized()).toRotationMatrix();
  SurfaceMesh turned = double_bubble(8);
  for (Vertex v : turned.vertices()) turned.set_position(v, turn * turned.position(v));
  Simulation one(double_bubble(8), {}, parts(tension())), other(std::move(turned), {}, parts(tension()));
  for (int i = 0; i < 10; ++i) {
    one.step();
    other.step();
  }
  for (Vertex v : one.mesh().vertices())
    EXPECT_LT((turn * one.mesh().position(v) - other.mesh().position(v)).norm(), 1e-11);
}

}  // namespace
}  // namespace foamsim
