// Films in a frame: a Plateau border and a Plateau vertex that start off their places find Plateau's angles.
#include "FoamSim/scenes/shapes/junction_frames.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <numbers>

#include "FoamSim/metrics/junction_angles.h"
#include "FoamSim/metrics/metrics.h"
#include "FoamSim/scenes/scene.h"
#include "LosTopos/mesh/audit.h"

namespace foamsim {
namespace {

using lostopos::Edge;
using lostopos::SurfaceMesh;
using lostopos::Vec3;
using lostopos::Vertex;

constexpr double degree = std::numbers::pi / 180;
const double flat_quad_area = 2 * std::numbers::sqrt2;  // six triangles of two sides 1 at arccos(−1/3)

void expect_clean(const SurfaceMesh& mesh) {
  const lostopos::AuditReport report = lostopos::audit(mesh, {.closed_regions = false});
  EXPECT_TRUE(report.clean()) << report.text();
}

TEST(TripleJunctionFrame, IsThreeFlatSquaresWithoutDisplacement) {
  for (long n : {0L, 2L}) {
    const SurfaceMesh mesh = triple_junction_frame(n, 0);
    EXPECT_EQ(mesh.triangle_count(), 12U << (2 * n));
    EXPECT_NEAR(lostopos::total_area(mesh), 3, 1e-12);
    EXPECT_EQ(lostopos::junction_edge_count(mesh), 1U << n);
    EXPECT_NEAR(*junction_angles(mesh).rms_deviation_deg, 0, 1e-6);
    EXPECT_TRUE(closed_region_volumes(mesh).empty());
    expect_clean(mesh);
  }
  expect_clean(triple_junction_frame(3, 0.6));
}

TEST(QuadJunctionFrame, IsSixFlatTrianglesWithoutDisplacement) {
  for (long n : {0L, 2L}) {
    const SurfaceMesh mesh = quad_junction_frame(n, 0);
    EXPECT_EQ(mesh.triangle_count(), 6U << (2 * n));
    EXPECT_NEAR(lostopos::total_area(mesh), flat_quad_area, 1e-12);
    EXPECT_EQ(lostopos::junction_edge_count(mesh), 4U << n);
    EXPECT_NEAR(*junction_angles(mesh).rms_deviation_deg, 0, 1e-6);
    EXPECT_EQ(lostopos::regions(mesh).size(), 4U);
    expect_clean(mesh);
  }
  expect_clean(quad_junction_frame(3, 0.3));
}

struct Rest {
  Simulation simulation;
  StepReport last;
};

Rest brought_to_rest(const char* name, long n, double displacement, const std::string& area = "averaged") {
  Scene scene = built_in_scene(name);
  scene.options.set("n", n, "test");
  scene.options.set("displacement", displacement, "test");
  scene.options.set("area", area, "test");
  Rest rest{make_simulation(scene), {}};
  const std::vector<Vec3> start(rest.simulation.mesh().positions().begin(), rest.simulation.mesh().positions().end());
  while (rest.simulation.time() < scene.options.number("time")) rest.last = rest.simulation.step();
  expect_clean(rest.simulation.mesh());
  // The frame has not moved: every vertex on a free edge still lies where one did at the start.
  const SurfaceMesh& mesh = rest.simulation.mesh();
  for (Edge e : mesh.edges()) {
    if (mesh.triangles(e).size() != 1) continue;
    for (Vertex v : mesh.vertices(e)) {
      EXPECT_TRUE(is_held(rest.simulation.held()[v.index()]));
      EXPECT_TRUE(std::ranges::any_of(start, [&](const Vec3& x) { return x == mesh.position(v); }));
    }
  }
  return rest;
}

TEST(TripleJunctionScene, ComesToRestAt120Degrees) {
  const Rest rest = brought_to_rest("triplejunction-frame", 2, 0.2);
  const SurfaceMesh& mesh = rest.simulation.mesh();
  EXPECT_LT(*junction_angles(mesh).rms_deviation_deg, 1);
  EXPECT_NEAR(lostopos::total_area(mesh) / 3, 1, 2e-4);
  EXPECT_LT(rest.last.kinetic_energy, 1e-3 * rest.last.potential_energy);
  for (Vertex v : mesh.vertices())
    if (mesh.is_junction(v)) {
      EXPECT_LT(std::hypot(mesh.position(v).x(), mesh.position(v).y()), 0.01);
    }
}

struct PlateauVertex {
  Vec3 position;
  std::vector<double> angles;  // between its four borders, degrees
};

PlateauVertex plateau_vertex(const SurfaceMesh& mesh) {
  std::vector<PlateauVertex> found;
  for (Vertex v : mesh.vertices()) {
    std::vector<Vec3> borders;
    for (Edge e : mesh.edges(v))
      if (mesh.is_junction(e))
        borders.push_back((mesh.position(mesh.other_vertex(e, v)) - mesh.position(v)).normalized());
    if (borders.size() != 4) continue;
    found.push_back({mesh.position(v), {}});
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < i; ++j) found.back().angles.push_back(std::acos(borders[i].dot(borders[j])) / degree);
  }
  EXPECT_EQ(found.size(), 1U);
  return found.front();
}

void print(const PlateauVertex& vertex, long n, double resolution) {
  std::cout << "n = " << n << ": " << vertex.position.norm() / resolution << " of an edge off, angles "
            << std::ranges::min(vertex.angles) << " to " << std::ranges::max(vertex.angles) << "\n";
}

TEST(QuadJunctionScene, ComesToRestAtTheTetrahedralAngle) {
  const Rest rest = brought_to_rest("quadjunction-frame", 4, 0.2);
  EXPECT_LT(*junction_angles(rest.simulation.mesh()).rms_deviation_deg, 0.2);
  EXPECT_NEAR(lostopos::total_area(rest.simulation.mesh()) / flat_quad_area, 1, 1e-5);
  const PlateauVertex vertex = plateau_vertex(rest.simulation.mesh());
  EXPECT_LT(vertex.position.norm(), 0.001);
  for (double angle : vertex.angles) EXPECT_NEAR(angle, 109.4712, 0.2);
}

// What one area for all regions cannot do: balance borders whose first edges differ in length.
TEST(QuadJunctionScene, SharingByBorderLengthRestsAtTheTetrahedralAngleWhereBordersAreUneven) {
  for (long n : {2L, 3L}) {
    const Rest rest = brought_to_rest("quadjunction-frame", n, 0.1, "border-length");
    const PlateauVertex vertex = plateau_vertex(rest.simulation.mesh());
    print(vertex, n, rest.simulation.resolution());
    EXPECT_LT(vertex.position.norm(), 1e-3 * rest.simulation.resolution());
    for (double angle : vertex.angles) EXPECT_NEAR(angle, 109.4712, 0.1);
    EXPECT_NEAR(lostopos::total_area(rest.simulation.mesh()) / flat_quad_area, 1, 1e-6);
  }
}

// Where the four borders' first edges differ in length the vertex rests off the middle, by less than a third of h̄.
TEST(QuadJunctionScene, RestsWithinAThirdOfAnEdgeWhereBordersAreUneven) {
  for (long n : {2L, 3L}) {
    const Rest rest = brought_to_rest("quadjunction-frame", n, 0.1);
    const PlateauVertex vertex = plateau_vertex(rest.simulation.mesh());
    print(vertex, n, rest.simulation.resolution());
    EXPECT_LT(vertex.position.norm(), rest.simulation.resolution() / 3);
    EXPECT_NEAR(lostopos::total_area(rest.simulation.mesh()) / flat_quad_area, 1, 2e-3);
  }
}

}  // namespace
}  // namespace foamsim
