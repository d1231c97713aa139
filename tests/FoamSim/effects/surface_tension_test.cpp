#include "FoamSim/effects/surface_tension.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "FoamSim/dynamics/simulation.h"
#include "FoamSim/scenes/shapes/double_bubble.h"
#include "FoamSim/scenes/shapes/solids.h"
#include "FoamSim/sheet/pressure/edge_angle.h"
#include "FoamSim/sheet/pressure/vertex_area/registry.h"
#include "LosTopos/mesh/measures.h"
#include "tests/FoamSim/film_parts.h"

namespace foamsim {
namespace {

using lostopos::air;
using lostopos::Region;
using lostopos::SurfaceMesh;
using lostopos::Vertex;

std::unique_ptr<PressureScheme> scheme(std::string_view area = "averaged") {
  return std::make_unique<EdgeAngle>(make_vertex_area(area, {}));
}

TEST(SurfaceTensionTest, AddsSigmaTimesTheJumpOfCurvatureToEveryPair) {
  for (const VertexAreaEntry& area : vertex_area_strategies()) {
    SurfaceMesh mesh = double_bubble(12);
    SurfaceGeometry geometry;
    geometry.update(mesh);
    CurvatureField curvature;
    curvature.update(mesh, geometry, EdgeAngleCurvature(make_vertex_area(area.name, {})));
    CirculationField circulation(mesh);
    SurfaceTension(1.5, scheme(area.name)).update_circulation({mesh, geometry, 0, 0.02}, circulation);
    for (Vertex v : mesh.vertices())
      for (const auto& [pair, value] : circulation.at(v))
        EXPECT_EQ(value, 1.5 * 0.02 * (curvature.get(geometry, v, pair.low) - curvature.get(geometry, v, pair.high)));
  }
}

TEST(SurfaceTensionTest, GivesTheThreeFilmsOfABorderWhatAddsUpToNothing) {
  SurfaceMesh mesh = double_bubble(16);
  SurfaceGeometry geometry;
  geometry.update(mesh);
  CirculationField circulation(mesh);
  SurfaceTension(1, scheme()).update_circulation({mesh, geometry, 0, 0.01}, circulation);
  const Region r0(0), r1(1), r2(2);
  for (Vertex v : mesh.vertices())
    if (mesh.is_junction(v)) {
      const double around = circulation.get(v, {r0, r1}) + circulation.get(v, {r1, r2}) + circulation.get(v, {r2, r0});
      EXPECT_NEAR(around, 0, 1e-15);
      EXPECT_NE(circulation.get(v, {r0, r1}), 0);
    }
}

TEST(SurfaceTensionTest, OfABubbleGrowsByFourSigmaOverTheRadius) {
  // H is 2/R inside and −2/R outside: dΓ/dt = 4σ/R; the potential jumps by 2Γ, the pressure by 8σ/R.
  SurfaceMesh mesh = icosphere(4, 2);
  SurfaceGeometry geometry;
  geometry.update(mesh);
  CirculationField circulation(mesh);
  SurfaceTension(3, scheme()).update_circulation({mesh, geometry, 0, 0.01}, circulation);
  for (Vertex v : mesh.vertices())
    if (mesh.triangles(v).size() == 6) {
      EXPECT_NEAR(circulation.get(v, {Region(1), air}), 4 * 3.0 / 2 * 0.01, 0.06 * 0.005);
    }
}

TEST(SurfaceTensionTest, EnergyIsFourSigmaTimesTheArea) {
  const SurfaceMesh mesh = double_bubble(12);
  SurfaceGeometry geometry;
  geometry.update(mesh);
  EXPECT_DOUBLE_EQ(SurfaceTension(0.25, scheme()).potential_energy(geometry), lostopos::total_area(mesh));
}

Simulation sphere_under_tension(long n) {
  return {icosphere(n), {}, test::parts(test::tension(), "rk4")};
}

TEST(SurfaceTensionTest, ABubbleWhoseVerticesAreAllAlikeStaysAtRest) {
  // The icosahedron: equal curvature everywhere, so that circulation grows by the same everywhere.
  Simulation simulation = sphere_under_tension(0);
  for (int i = 0; i < 100; ++i) simulation.step();
  for (Vertex v : simulation.mesh().vertices()) EXPECT_NEAR(simulation.mesh().position(v).norm(), 1, 1e-12);
  // Five edges of length e that turn by π − acos(−√5/3), over five thirds of a triangle.
  const double e = 1 / std::sin(2 * std::numbers::pi / 5);
  const double curvature =
      5 * e * (std::numbers::pi - std::acos(-std::sqrt(5.0) / 3)) / (2 * 5.0 / 3 * std::sqrt(3.0) / 4 * e * e);
  for (Vertex v : simulation.mesh().vertices())
    EXPECT_NEAR(simulation.circulation().get(v, {Region(1), air}), 2 * curvature, 1e-11);
}

double largest_departure(long n) {
  Simulation simulation = sphere_under_tension(n);
  double largest = 0;
  for (int i = 0; i < 100; ++i) {
    simulation.step();
    for (Vertex v : simulation.mesh().vertices())
      largest = std::max(largest, std::abs(simulation.mesh().position(v).norm() - 1));
  }
  return largest;
}

TEST(SurfaceTensionTest, ASphereTendsToStayAtRestAsItIsRefined) {
  // Measured over one unit of time: see the bounds. The departures are those of the twelve five-fold vertices.
  const double coarse = largest_departure(2), fine = largest_departure(3);
  EXPECT_LT(coarse, 0.012);
  EXPECT_LT(fine, 0.004);
  EXPECT_GT(std::log2(coarse / fine), 1.0);
}

}  // namespace
}  // namespace foamsim
