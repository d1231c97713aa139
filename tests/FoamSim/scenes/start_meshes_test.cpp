// Start meshes of the built-in scenes: counts, labels, positions by their formulas, what is held and what is solid.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "FoamSim/scenes/scene.h"
#include "FoamSim/scenes/shapes/edge_distance.h"
#include "FoamSim/scenes/shapes/solids.h"
#include "LosTopos/mesh/audit.h"
#include "LosTopos/mesh/measures.h"
#include "tests/FoamSim/scenes/start_mesh.h"

namespace foamsim {
namespace {

using lostopos::Region;
using lostopos::SurfaceMesh;
using lostopos::Triangle;
using lostopos::Vec3;
using lostopos::Vertex;
using std::numbers::pi;
using std::numbers::sqrt3;
using test::StartMesh;

constexpr double exact = 1e-12;

// (along, r cos, r sin) at the angles 2πk/count.
std::vector<Vec3> ring(long count, double along, double radius) {
  std::vector<Vec3> points;
  for (long k = 0; k < count; ++k) {
    const double angle = 2 * pi * static_cast<double>(k) / static_cast<double>(count);
    points.emplace_back(along, radius * std::cos(angle), radius * std::sin(angle));
  }
  return points;
}

void append(std::vector<Vec3>& points, const std::vector<Vec3>& more) {
  points.insert(points.end(), more.begin(), more.end());
}

double area_of_polygon(long sides, double radius) {
  const auto n = static_cast<double>(sides);
  return n / 2 * radius * radius * std::sin(2 * pi / n);
}

TEST(StartMesh, SphereIsAnEllipsoid) {
  const StartMesh start("sphere", {"n=2"});
  start.expect_counts({.vertices = 162, .triangles = 320});
  for (Vertex v : start.mesh().vertices()) {
    const Vec3 x = start.mesh().position(v);
    EXPECT_NEAR(Vec3(x.x() / 0.4, x.y(), x.z()).norm(), 1, exact);
  }
  EXPECT_NEAR(start.volume(1), 0.4 * lostopos::region_volumes(icosphere(2))[1].volume, exact);
}

TEST(StartMesh, TetAndCubeHaveTheirCorners) {
  const double s = 1 / sqrt3;
  const StartMesh tet("tet", {"n=3"});
  tet.expect_counts({.vertices = 130, .triangles = 256});
  tet.expect_among_positions({{-s, -s, -s}, {-s, s, s}, {s, -s, s}, {s, s, -s}});
  EXPECT_NEAR(tet.area(), 8 / sqrt3, exact);
  EXPECT_NEAR(tet.volume(1), 8.0 / 3 / (3 * sqrt3), exact);
  const StartMesh cube("cube", {"n=2"});
  cube.expect_counts({.vertices = 98, .triangles = 192});
  cube.expect_among_positions({{-s, -s, -s}, {s, -s, -s}, {-s, s, -s}, {-s, -s, s}, {s, s, s}});
  EXPECT_NEAR(cube.area(), 8, exact);
  EXPECT_NEAR(cube.volume(1), 8 / (3 * sqrt3), exact);
}

TEST(StartMesh, DoubleBubbleTakesSegmentsOfItsOwn) {
  const StartMesh start("doublebubble", {"n=24", "m=30"});
  start.expect_counts({.vertices = 2 * (20 * 30 + 1) + 30 + 1, .triangles = 2 * 30 * 41 + 30, .regions = 3});
  EXPECT_NEAR(start.volume(1), start.volume(2), exact);
  const StartMesh square("doublebubble", {"n=24", "m=24"}), left_out("doublebubble", {"n=24"});
  EXPECT_EQ(square.positions(), left_out.positions());
}

TEST(StartMesh, TwoBubblesAreEllipsoidsWithAGap) {
  const StartMesh start("twobubbles", {"n=2"});
  start.expect_counts({.vertices = 324, .triangles = 640, .regions = 3});
  double nearest = 1;
  for (Vertex v : start.mesh().vertices()) {
    const Vec3 x = start.mesh().position(v);
    nearest = std::min(nearest, std::abs(x.x()));
    EXPECT_NEAR(Vec3(std::abs(x.x()) / 0.7 - 1.02, x.y(), x.z()).norm(), 1, exact);
  }
  EXPECT_NEAR(2 * nearest, 0.028, exact);
  EXPECT_NEAR(start.volume(1), 0.7 * lostopos::region_volumes(icosphere(2))[1].volume, exact);
}

TEST(StartMesh, FoaminitIsThreeSpheres) {
  const StartMesh start("foaminit");
  start.expect_counts({.vertices = 126, .triangles = 240, .regions = 4});
  for (Vertex v : start.mesh().vertices()) {
    const Vec3 x = start.mesh().position(v);
    const double from_nearest = std::min(
        {(x - Vec3(1, 0, 0)).norm(), (x - Vec3(-0.5, 0, sqrt3 / 2)).norm(), (x - Vec3(-0.5, 0, -sqrt3 / 2)).norm()});
    EXPECT_NEAR(from_nearest, 0.5, exact);
  }
  for (int region : {1, 2, 3}) EXPECT_NEAR(start.volume(region), 0.4573, 5e-5);
}

TEST(StartMesh, BarrelIsAStackOfRings) {
  const StartMesh start("barrel");
  start.expect_counts({.vertices = 240, .triangles = 432, .open_edges = 48});
  std::vector<Vec3> points;
  for (int i = 0; i < 10; ++i)
    for (const Vec3& x : ring(24, i / 9.0 - 0.5, 1)) points.emplace_back(x.y(), x.x(), x.z());
  start.expect_positions(points);
  EXPECT_NEAR(start.area(), 48 * std::sin(pi / 24), exact);
  for (Triangle t : start.mesh().triangles()) {
    Vec3 out = lostopos::barycentre(start.mesh(), t);
    out.y() = 0;
    EXPECT_EQ(start.mesh().labels(t).p, Region(lostopos::area_vector(start.mesh(), t).dot(out) > 0 ? 1 : 0));
  }
}

TEST(StartMesh, TripleJunctionIsThreeRectangles) {
  const StartMesh start("triplejunction");
  start.expect_counts({.vertices = 65, .triangles = 96, .open_edges = 3 * 12, .regions = 3});
  std::vector<Vec3> points;
  for (int along = 0; along <= 4; ++along) {
    points.emplace_back(0, along / 4.0, 0);
    for (const Vec3& foot : {Vec3(2, 0, 0), Vec3(-0.5, 0, -sqrt3 / 2), Vec3(-0.5, 0, sqrt3 / 2)})
      for (int out = 1; out <= 4; ++out) points.emplace_back(out / 4.0 * foot + Vec3(0, along / 4.0, 0));
  }
  start.expect_positions(points);
  EXPECT_NEAR(start.area(), 4, exact);
  EXPECT_EQ(lostopos::junction_edge_count(start.mesh()), 4U);
}

TEST(StartMesh, QuadJunctionIsSixQuadrilaterals) {
  const double a = 0.5 * std::numbers::sqrt2;
  const StartMesh flat("quadjunction", {"n=0"});
  flat.expect_counts({.vertices = 11, .triangles = 12, .open_edges = 12, .regions = 4});
  flat.expect_positions({{-0.7, 0, -0.7 * a},
                         {-1, 0, -a},
                         {1, 0, -a},
                         {0, -1, a},
                         {0, 1, a},
                         {0, 0, -2 * a},
                         {-1, -1, 0},
                         {-1, 1, 0},
                         {1, -1, 0},
                         {1, 1, 0},
                         {0, 0, 2 * a}});
  const StartMesh start("quadjunction");
  start.expect_counts({.vertices = 113, .triangles = 192, .open_edges = 48, .regions = 4});
  EXPECT_NEAR(start.area(), 9.0363, 5e-5);
}

TEST(StartMesh, ConstrainedSphereIsHeldByALoopRoundItsPole) {
  const StartMesh start("constrainedsphere");
  start.expect_counts({.vertices = 642, .triangles = 1280, .held = 12});
  EXPECT_NEAR(start.area(), 9.3447, 5e-5);
  EXPECT_NEAR(start.volume(1), 2.4916, 5e-5);
  // (y, z) of one quarter, measured of the reference to three digits.
  std::vector<Vec3> expected;
  for (const auto& [y, z] : {std::pair{0.0, 0.273}, {0.263, 0.162}, {0.266, 0.0}, {0.133, 0.220}})
    for (double sign_y : {-1, 1})
      for (double sign_z : {-1, 1}) expected.emplace_back(0, sign_y * y, sign_z * z);
  for (Vertex v : start.held()) {
    const Vec3 x = start.mesh().position(v);
    EXPECT_TRUE(x.x() > -0.581 && x.x() < -0.570) << x.x();
    const bool found = std::ranges::any_of(
        expected, [&](const Vec3& e) { return std::abs(x.y() - e.y()) < 6e-4 && std::abs(x.z() - e.z()) < 6e-4; });
    EXPECT_TRUE(found) << x.transpose();
  }
}

void expect_wand(const StartMesh& start, long n) {
  const auto count = static_cast<std::size_t>(n);
  start.expect_counts({.vertices = count + 2, .triangles = 2 * count, .held = count + 1, .solid = count});
  std::vector<Vec3> points = ring(n, 0, 1);
  append(points, {{0, 0, 0}, {-1, 0, 0}});
  start.expect_positions(points);
  EXPECT_NEAR(start.volume(1), area_of_polygon(n, 1) / 3, exact);
  for (Triangle t : start.mesh().triangles()) {
    const bool cone = lostopos::barycentre(start.mesh(), t).x() < -0.1;
    EXPECT_EQ(start.is_solid(t), cone);
    if (!cone) {
      EXPECT_EQ(start.mesh().labels(t), (lostopos::Labels{Region(1), lostopos::air}));
      EXPECT_GT(lostopos::area_vector(start.mesh(), t).x(), 0);
    }
  }
}

TEST(StartMesh, BubbleWandAndStrawAreADiscAndASolidCone) {
  const StartMesh wand_scene("bubblewand"), straw("straw");
  expect_wand(wand_scene, 12);
  EXPECT_NEAR(wand_scene.volume(1), 1, exact);
  expect_wand(straw, 24);
  EXPECT_NEAR(straw.volume(1), 1.035, 5e-4);
}

TEST(StartMesh, TwoRingsAreClosedByCones) {
  const StartMesh start("tworingspinching");
  start.expect_counts({.vertices = 74, .triangles = 144, .held = 50, .solid = 48});
  std::vector<Vec3> points{{-1.15, 0, 0}, {1.15, 0, 0}};
  for (double x : {-0.15, 0.0, 0.15}) append(points, ring(24, x, 0.5));
  start.expect_positions(points);
  EXPECT_NEAR(start.volume(1), area_of_polygon(24, 0.5) * (0.3 + 2.0 / 3), exact);
}

TEST(StartMesh, PeanutIsTwoSpheresInOne) {
  const StartMesh start("peanutbubble");
  start.expect_counts({.vertices = 2 * (15 * 30 + 1) + 30, .triangles = 2 * 30 * 31, .held = 30});
  std::vector<Vec3> points = ring(30, 0, std::sin(pi / 3));
  append(points, {{-1.5, 0, 0}, {1.499, 0, 0}});
  for (int i = 1; i < 16; ++i) {
    const double polar = pi * i / 24, r = 0.999 + 0.001 * i / 16;
    append(points, ring(30, -0.5 - std::cos(polar), std::sin(polar)));
    append(points, ring(30, 0.5 + r * std::cos(polar), r * std::sin(polar)));
  }
  start.expect_positions(points);
  for (Vertex v : start.held()) EXPECT_NEAR(start.mesh().position(v).x(), 0, exact);
}

TEST(StartMesh, CarouselIsTwoHeldBubblesAndAStraw) {
  const StartMesh start("carousel");
  start.expect_counts({.vertices = 933 + 14, .triangles = 1890 + 24, .regions = 4, .held = 60 + 13, .solid = 12});
  const double angle = 37.5 * pi / 180, x = 2 + 4 * std::cos(angle), r = 4 * std::sin(angle);
  EXPECT_NEAR(x, 5.1734, 5e-5);
  EXPECT_NEAR(r, 2.4350, 5e-5);
  std::vector<Vec3> held{{0, -7, 0}};
  for (double side : {-x, x}) append(held, ring(30, side, r));
  for (const Vec3& p : ring(12, -6, 1)) held.emplace_back(p.y(), p.x(), p.z());
  start.expect_held_at(held);
  EXPECT_NEAR(start.volume(3), 1, exact);
  EXPECT_NEAR(start.volume(1), start.volume(2), 1e-10);
  double wall = 0;
  for (Triangle t : start.mesh().triangles())
    if (!start.mesh().labels(t).has(lostopos::air)) wall += lostopos::area(start.mesh(), t);
  EXPECT_NEAR(wall, area_of_polygon(30, 2 * sqrt3), exact);
}

TEST(StartMesh, SheetIsAHexagonWithALoweredBorder) {
  for (long n : {1L, 2L, 3L}) {
    const StartMesh start("sheet", {"n=" + std::to_string(n)});
    const auto side = std::size_t{1} << n;
    start.expect_counts({.vertices = 3 * side * (side + 1) + 1,
                         .triangles = 6 * side * side,
                         .open_edges = 6 * side,
                         .held = 6 * side});
    for (Vertex v : start.mesh().vertices()) {
      const Vec3 x = start.mesh().position(v);
      const bool border = std::ranges::find(start.held(), v) != start.held().end();
      EXPECT_NEAR(x.y(), border ? 0.2 - 0.6 * x.z() * x.z() : 0.2, exact);
      const double apothem =
          std::max({std::abs(x.z()), std::abs(x.z() + sqrt3 * x.x()) / 2, std::abs(x.z() - sqrt3 * x.x()) / 2});
      EXPECT_EQ(border, apothem > sqrt3 / 2 - exact);
    }
    start.expect_among_positions({{0, -0.25, sqrt3 / 2}, {1, 0.2, 0}});
  }
}

TEST(StartMesh, OctahedronHasARegionBehindEachFace) {
  const StartMesh start("octahedron", {"seed=3"});
  start.expect_counts({.vertices = 19, .triangles = 48, .regions = 9, .held = 14, .solid = 24});
  std::vector<Vec3> held;
  for (int k = 0; k < 3; ++k)
    for (double s : {-1, 1}) held.emplace_back(s * Vec3::Unit(k));
  for (double x : {-0.5, 0.5})
    for (double y : {-0.5, 0.5})
      for (double z : {-0.5, 0.5}) held.emplace_back(x, y, z);
  start.expect_held_at(held);
  start.expect_among_positions({{0.3, 0.3, 0.3}, {-0.3, -0.3, 0.3}, {-0.3, 0.3, -0.3}, {0.3, -0.3, -0.3}});
  double total = 0;
  for (int region = 1; region <= 8; ++region) {
    total += start.volume(region);
    EXPECT_GT(start.volume(region), 0) << region;
  }
  // The octahedron, 4/3, and eight caps of height (3/2 − 1)/√3 on faces of area √3/2.
  EXPECT_NEAR(total, 4.0 / 3 + 8 * (sqrt3 / 2) * (0.5 / sqrt3) / 3, exact);
  // Behind the face of T: a tetrahedron that its three films cut off, and the cap.
  for (int region = 5; region <= 8; ++region) EXPECT_NEAR(start.volume(region), 0.1 / 6 + 1.0 / 12, exact);
  EXPECT_NE(start.positions(), StartMesh("octahedron", {"seed=4"}).positions());
}

TEST(EdgeDistance, CountsEdges) {
  const SurfaceMesh mesh = icosphere(3);
  const Vertex corner(0);  // five edges meet there, six elsewhere near it
  EXPECT_EQ(at_edge_distance(mesh, corner, 0), std::vector{corner});
  EXPECT_EQ(at_edge_distance(mesh, corner, 1).size(), 5U);
  EXPECT_EQ(at_edge_distance(mesh, corner, 2).size(), 10U);
  EXPECT_TRUE(at_edge_distance(mesh, corner, 100).empty());
}

}  // namespace
}  // namespace foamsim
