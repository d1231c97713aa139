// Surfaces of the kind that the reference's files hold: foams that end at the walls of the unit box with 0 an ordinary
// region, a surface that is inside out; and the area's gradient as the flow.
#include <gtest/gtest.h>

#include <cmath>

#include "LosTopos/shapes/solids.h"
#include "LosTopos/shapes/voronoi_foam.h"
#include "MultiTracker/flows/area_gradient.h"
#include "tests/MultiTracker/tracking_checks.h"

namespace multitracker {
namespace {

using lostopos::Hold;
using lostopos::Region;
using lostopos::SurfaceMesh;
using lostopos::Triangle;
using lostopos::Vec3;
using lostopos::Vertex;

// Without the walls, and region 1 by the name of 0; `off`: how far vertices are from the walls they are at.
SurfaceMesh foam_that_ends_at_walls(long cells, double off = 0) {
  SurfaceMesh mesh = lostopos::voronoi_foam({.cells = cells, .seed = 3, .subdivisions = 2});
  std::vector<Triangle> walls;
  for (Triangle t : mesh.triangles())
    if (mesh.labels(t).has(lostopos::air)) walls.push_back(t);
  for (Triangle t : walls) mesh.remove_triangle(t);
  const auto renamed = [](Region r) { return r == Region(1) ? lostopos::air : r; };
  for (Triangle t : mesh.triangles()) mesh.set_labels(t, {renamed(mesh.labels(t).p), renamed(mesh.labels(t).q)});
  for (std::size_t v = 0; v < mesh.vertex_slots(); ++v)
    if (mesh.alive(Vertex(v)) && mesh.triangles(Vertex(v)).empty()) mesh.remove_vertex(Vertex(v));
  for (Vertex v : mesh.vertices()) {
    Vec3 x = mesh.position(v);
    for (int i = 0; i < 3; ++i) x[i] += x[i] == 0 ? off : x[i] == 1 ? -off : 0;
    mesh.set_position(v, x);
  }
  mesh.compact();
  return mesh;
}

Tracking start_on(std::string_view name, const SurfaceMesh& mesh, const test::Settings& settings = {}) {
  const SceneEntry& scene = scene_by_name(name);
  return Tracking(Origin{
      .scene = &scene, .options = test::options_with(scene, settings), .mesh_file = "given", .given = mesh.state()});
}

TEST(WallScenes, AFoamThatEndsAtWallsCoarsensCleanly) {
  for (const char* flow : {"flow=curvature", "flow=area-gradient"}) {
    Tracking tracking = start_on("mcf", foam_that_ends_at_walls(6, 4e-7), {flow});
    ASSERT_EQ(tracking.audit().text(), "clean");
    const double area = tracking.metrics().area;
    std::size_t sliding = 0;
    for (Vertex v : tracking.mesh().vertices())
      for (int i = 0; i < 3; ++i)
        if (const double x = tracking.mesh().position(v)[i]; x < 1e-3 || x > 1 - 1e-3) {
          ++sliding;
          EXPECT_TRUE(x == 0 || x == 1) << x;
          EXPECT_TRUE(lostopos::holds(tracking.tracker().held()[v], i));
        }
    EXPECT_GT(sliding, 50u);
    for (int i = 0; i < 12; ++i)
      if (!test::step_and_audit(tracking)) return;
    EXPECT_LT(tracking.metrics().area, area);
    for (Vertex v : tracking.mesh().vertices()) {
      EXPECT_GE(tracking.mesh().position(v).minCoeff(), 0);
      EXPECT_LE(tracking.mesh().position(v).maxCoeff(), 1);
    }
  }
}

TEST(WallScenes, T2sWallVerticesDoNotMoveAtAll) {
  const SurfaceMesh mesh = foam_that_ends_at_walls(5, 4e-7);
  std::vector<Vec3> at_walls;
  for (Vertex v : mesh.vertices())
    if (lostopos::walls_at({}, mesh.position(v)) != Hold::none)
      at_walls.push_back(lostopos::put_on_walls({}, mesh.position(v)));
  Tracking tracking = start_on("T2", mesh, {"remeshing.enabled=false", "topology.enabled=false"});
  for (int i = 0; i < 5; ++i) ASSERT_TRUE(test::step_and_audit(tracking));
  std::size_t found = 0;
  for (Vertex v : tracking.mesh().vertices())
    found += static_cast<std::size_t>(std::ranges::count(at_walls, tracking.mesh().position(v)));
  EXPECT_EQ(found, at_walls.size());
}

TEST(WallScenes, ABubbleThatDoesNotReachThemKnowsNoWalls) {
  Tracking tracking = start_on("T2", lostopos::icosphere(1, 0.3));
  for (Vertex v : tracking.mesh().vertices()) EXPECT_EQ(tracking.tracker().held()[v], Hold::all);  // the air's side
  EXPECT_TRUE(test::step_and_audit(tracking));
}

// v = −2 ∂A/∂x: at the middle of a fan of n triangles around a regular n-gon whose middle is off its plane by z,
// A = n r' s / 2 with s the side and r' = sqrt(r²cos² + z²) the height of each, so v = −n s z / r'.
TEST(AreaGradient, IsNotDividedByAnArea) {
  constexpr int n = 6;
  for (double radius : {1.0, 0.1}) {
    SurfaceMesh mesh;
    const double z = 0.2 * radius, side = 2 * radius * std::sin(M_PI / n);
    const Vertex middle = mesh.add_vertex({0, 0, z});
    for (int i = 0; i < n; ++i)
      (void)mesh.add_vertex({radius * std::cos(2 * M_PI * i / n), radius * std::sin(2 * M_PI * i / n), 0});
    for (std::size_t i = 0; i < n; ++i)
      (void)mesh.add_triangle(middle, Vertex(1 + i), Vertex(1 + (i + 1) % n), {Region(1), lostopos::air});
    std::vector<Hold> held(n + 1, Hold::all);
    held[0] = Hold::none;
    const double dt = 1e-4 * radius;
    const Vec3 end = AreaGradientFlow().predicted({mesh, held, 0, dt})[0];
    const double height = std::hypot(radius * std::cos(M_PI / n), z);
    EXPECT_NEAR((end.z() - z) / dt, -n * side * z / height, 1e-9 * radius);
    EXPECT_NEAR(end.head<2>().norm(), 0, 1e-15);
  }
}

// However long the step: a bubble's edges do not turn over.
TEST(AreaGradient, ShortensNoEdgeToNothing) {
  const SurfaceMesh mesh = lostopos::icosphere(1, 0.5);
  const std::vector<Hold> held(mesh.vertex_slots(), Hold::none);
  const auto ends = AreaGradientFlow().predicted({mesh, held, 0, 0.02});
  for (lostopos::Edge e : mesh.edges()) {
    const auto [a, b] = mesh.vertices(e);
    const Vec3 before = mesh.position(b) - mesh.position(a), after = ends[b.index()] - ends[a.index()];
    EXPECT_GT(after.dot(before), 0);
  }
}

TEST(StepLengths, GrowAtTheirTimes) {
  StepLengths dt(0.5);
  EXPECT_EQ(dt.time_of(40), 20);
  dt.grow_from(6, 4).grow_from(30, 4);
  EXPECT_EQ(dt.time_of(12), 6);
  EXPECT_EQ(dt.of_step(11), 0.5);
  EXPECT_EQ(dt.of_step(12), 2);
  EXPECT_EQ(dt.time_of(24), 30);
  EXPECT_EQ(dt.of_step(24), 8);
  EXPECT_EQ(dt.time_of(26), 46);
}

}  // namespace
}  // namespace multitracker
