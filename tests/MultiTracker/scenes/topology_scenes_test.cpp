// The tracker's scenes against what must come of them, with an audit after every step.
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <map>
#include <numbers>
#include <set>

#include "FoamSim/metrics/junction_angles.h"
#include "MultiTracker/flows/mean_curvature.h"
#include "MultiTracker/flows/normal_flow.h"
#include "tests/MultiTracker/tracking_checks.h"

namespace multitracker {
namespace {

using lostopos::Region;
using lostopos::SurfaceMesh;
using lostopos::Vec3;
using test::have_film;
using test::Settings;
using test::start;
using test::step_and_audit;
using test::volume_of;

class T1 : public testing::TestWithParam<const char*> {};

// Regions 3 and 4 lose contact and 1 and 2 gain it; then the films come to rest as the shorter Steiner tree of the
// box's four creases, the walls where they were.
TEST_P(T1, TheLinesPartTheOtherWay) {
  Tracking tracking = start("T1", {GetParam(), "dt=0.005"});
  ASSERT_FALSE(have_film(tracking.mesh(), 1, 2));
  std::size_t separations = 0;
  for (int i = 0; i < 120; ++i) {
    ASSERT_TRUE(step_and_audit(tracking));
    separations += tracking.metrics().separations;
    EXPECT_NEAR(tracking.metrics().air_area, 3.6, 1e-12);
  }
  EXPECT_GT(separations, 0u);
  EXPECT_TRUE(have_film(tracking.mesh(), 1, 2));
  EXPECT_FALSE(have_film(tracking.mesh(), 3, 4));
  EXPECT_EQ(tracking.metrics().incomplete_vertices, 0u);
  EXPECT_EQ(tracking.metrics().regions, 5u);
  const double tree = 1.2 + 0.6 * std::sqrt(3.0);
  EXPECT_NEAR(tracking.metrics().shared_area / (0.6 * tree), 1, 1e-3);
}

INSTANTIATE_TEST_SUITE_P(Starts, T1, testing::Values("gap=0", "gap=0.12"),
                         [](const auto& info) { return info.index == 0 ? "FourFoldLine" : "TwoLines"; });

template <class Element>
std::set<std::size_t> regions_around(const SurfaceMesh& mesh, Element element) {
  std::set<std::size_t> regions;
  for (lostopos::Triangle t : mesh.triangles(element))
    regions.insert({mesh.labels(t).p.index(), mesh.labels(t).q.index()});
  return regions;
}

struct PrismRest {
  const char* name;
  double height;
  bool edge;           // in the middle, at rest
  double shared_area;  // of all films inside, at rest
};

// Films in a triangular prism with sides of 1. A vertical edge of length height - 1/sqrt(6) joins two Plateau vertices,
// and all films are flat, if the prism is higher than that. In a lower one a triangular face lies in the middle: area
// from Surface Evolver 2.70, linear elements, 1.04597 and 1.04585 after four and five refinements.
class Prism : public testing::TestWithParam<std::tuple<PrismRest, const char*>> {};

TEST_P(Prism, FindsItsRestFromAnEdgeAndFromAFace) {
  const auto& [rest, middle] = GetParam();
  Tracking tracking = start("prism", {"height=" + std::to_string(rest.height), std::string("middle=") + middle});
  const bool starts_with_edge = std::string(middle) == "edge";
  ASSERT_EQ(have_film(tracking.mesh(), 1, 2), !starts_with_edge);
  std::size_t separations = 0;
  double area = tracking.metrics().area;
  for (int i = 0; i < 200; ++i) {
    ASSERT_TRUE(step_and_audit(tracking));
    separations += tracking.metrics().separations;
    EXPECT_LE(tracking.metrics().area, 1.001 * area);
    area = tracking.metrics().area;
  }
  EXPECT_EQ(have_film(tracking.mesh(), 1, 2), !rest.edge);
  EXPECT_EQ(separations > 0, starts_with_edge != rest.edge);
  for (auto [a, b] : {std::pair(3, 4), {4, 5}, {5, 3}}) EXPECT_TRUE(have_film(tracking.mesh(), a, b));
  EXPECT_EQ(tracking.metrics().incomplete_vertices, 0u);
  EXPECT_EQ(tracking.metrics().regions, 6u);
  std::size_t edges_of_three_sides = 0, plateau_vertices = 0;
  for (lostopos::Edge e : tracking.mesh().edges())
    edges_of_three_sides += regions_around(tracking.mesh(), e) == std::set<std::size_t>{3, 4, 5};
  for (lostopos::Vertex v : tracking.mesh().vertices()) {
    const auto regions = regions_around(tracking.mesh(), v);
    plateau_vertices += regions.size() == 4 && !regions.contains(0);
  }
  EXPECT_EQ(edges_of_three_sides > 0, rest.edge);
  EXPECT_EQ(plateau_vertices, rest.edge ? 2u : 3u);
  EXPECT_NEAR(tracking.metrics().shared_area / rest.shared_area, 1, 1e-3);
}

INSTANTIATE_TEST_SUITE_P(T1, Prism,
                         testing::Combine(testing::Values(PrismRest{"High", 0.6, true, 1.746337},
                                                          PrismRest{"Low", 0.25, false, 1.0458}),
                                          testing::Values("edge", "face")),
                         [](const auto& info) {
                           return std::string(std::get<0>(info.param).name) + "From" +
                                  (std::string(std::get<1>(info.param)) == "edge" ? "Edge" : "Face");
                         });

TEST(T2, TheSmallRegionVanishesAndTheOthersKeepTheirVolumes) {
  Tracking tracking = start("T2");
  const double whole = -volume_of(tracking.mesh(), 0);
  for (int i = 0; i < 40; ++i) ASSERT_TRUE(step_and_audit(tracking));
  EXPECT_EQ(volume_of(tracking.mesh(), 5), 0);
  EXPECT_EQ(tracking.metrics().regions, 5u);
  for (std::size_t region = 1; region <= 4; ++region) {
    EXPECT_NEAR(volume_of(tracking.mesh(), region) / (whole / 4), 1, 1e-3)
        << "its own and a quarter of the small one's";
    for (std::size_t other = 1; other < region; ++other) EXPECT_TRUE(have_film(tracking.mesh(), region, other));
  }
  EXPECT_NEAR(-volume_of(tracking.mesh(), 0), whole, 1e-12);
  // The cone over the edges of the tetrahedron.
  EXPECT_NEAR(tracking.metrics().shared_area, 2 * std::sqrt(2.0), 2e-3);
}

TEST(Coalescence, TwoSpheresOfOneRegionBecomeOneSurface) {
  Tracking tracking = start("coalescence");
  ASSERT_EQ(lostopos::euler_characteristic(tracking.mesh()), 4);
  for (int i = 0; i < 40; ++i) ASSERT_TRUE(step_and_audit(tracking));
  EXPECT_EQ(lostopos::euler_characteristic(tracking.mesh()), 2);
  EXPECT_EQ(tracking.metrics().junction_edges, 0u);
}

// Grown into each other, then under tension, which closes the pockets of air that contact at many places leaves.
TEST(Contact, TwoBubblesGetOneWallInOneCircleOfBorder) {
  const SceneEntry& scene = scene_by_name("normal-flow");
  const base::OptionSet options = test::options_with(scene, {"spheres=2", "topology.separation=area"});
  lostopos::SurfaceTracker tracker = start_tracker(scene, options, scene.surface(options));
  const NormalFlow growth(1);
  const MeanCurvatureFlow tension;
  for (int i = 0; i < 60; ++i) {
    const SurfaceFlow& flow = i < 40 ? static_cast<const SurfaceFlow&>(growth) : tension;
    const double dt = i < 40 ? 0.1 * tracker.options().resolution : 0.001;
    tracker.step(flow.predicted({tracker.mesh(), tracker.held().slots(), 0, dt}));
    ASSERT_EQ(lostopos::audit(tracker.mesh()).text(), "clean") << "after step " << i + 1;
  }
  const SurfaceMesh& mesh = tracker.mesh();
  EXPECT_TRUE(have_film(mesh, 1, 2));
  // Two spheres and a disc inside.
  EXPECT_EQ(lostopos::euler_characteristic(mesh), 3);
  for (lostopos::Edge e : mesh.edges()) EXPECT_LE(mesh.triangles(e).size(), 3u);
  for (lostopos::Vertex v : mesh.vertices()) {
    int borders = 0;
    for (lostopos::Edge e : mesh.edges(v)) borders += mesh.is_junction(e);
    EXPECT_TRUE(borders == 0 || borders == 2);
  }
}

TEST(Catenoid, PinchesOffAndLeavesTwoDiscs) {
  Tracking tracking = start("catenoid");
  for (int i = 0; i < 320; ++i) ASSERT_TRUE(step_and_audit(tracking));
  const SurfaceMesh& mesh = tracking.mesh();
  EXPECT_EQ(lostopos::euler_characteristic(mesh), 2) << "two discs, no debris";
  const double discs = 32 * 0.25 * std::sin(2 * std::numbers::pi / 32);  // two polygons of 32 sides
  EXPECT_NEAR(lostopos::total_area(mesh) / discs, 1, 0.01);
  EXPECT_EQ(lostopos::open_edge_count(mesh), 64u);
}

TEST(CyclicFlow, WallsStayAndTheRegionsChaseEachOther) {
  Tracking tracking = start("cyclicflow");
  for (int i = 0; i < 20; ++i) ASSERT_TRUE(step_and_audit(tracking));
  EXPECT_NEAR(tracking.metrics().air_area, 6, 1e-12);
  EXPECT_EQ(tracking.metrics().regions, 4u);
  EXPECT_GT(tracking.metrics().shared_area, 1.7) << "the line turns into a spiral";
}

TEST(NormalFlow, PressesSpheresIntoAFoamForAnySeed) {
  for (const char* layout : {"layout=grid", "layout=random"})
    for (const char* seed : {"seed=1", "seed=2"}) {
      SCOPED_TRACE(std::string(layout) + " " + seed);
      Tracking tracking = start("normal-flow", {layout, seed, "step=0.1", "spheres=8"});
      for (int i = 0; i < 30; ++i) ASSERT_TRUE(step_and_audit(tracking));
      EXPECT_EQ(tracking.metrics().regions, 9u);
      EXPECT_GT(tracking.metrics().shared_area, std::string(layout) == "layout=grid" ? 4 : 0.1);
    }
}

// At the walls films do not meet at 120 degrees.
SurfaceMesh without_walls(const SurfaceMesh& mesh) {
  SurfaceMesh inside = mesh.clone();
  for (lostopos::Triangle t : mesh.triangles())
    if (mesh.labels(t).has(lostopos::air)) inside.remove_triangle(t);
  return inside;
}

// Angles at the edges of a Plateau border between the three films, each averaged over the border by length: the
// greatest distance from 120 degrees that the `share` of all border length keeps. Three angles around one edge average
// 120 whatever they are; these need not. The facets' own errors average out along a border, as far as films are flat.
double border_angle_error(const SurfaceMesh& mesh, double share) {
  struct Sum {
    double length = 0;
    std::map<std::size_t, double> angles;  // by region
  };
  std::map<std::set<std::size_t>, Sum> borders;
  for (lostopos::Edge e : mesh.edges()) {
    if (mesh.triangles(e).size() != 3) continue;
    const auto& ends = mesh.vertices(e);
    const Vec3 axis = mesh.position(ends[1]) - mesh.position(ends[0]);
    Sum& sum = borders[regions_around(mesh, e)];
    sum.length += axis.norm();
    for (std::size_t region : regions_around(mesh, e)) {
      std::vector<Vec3> arms;
      for (lostopos::Triangle t : mesh.triangles(e)) {
        if (!mesh.labels(t).has(Region(region))) continue;
        const Vec3 arm = mesh.position(mesh.opposite_vertex(t, e)) - mesh.position(ends[0]);
        arms.push_back((arm - axis * (arm.dot(axis) / axis.squaredNorm())).normalized());
      }
      sum.angles[region] += axis.norm() * std::acos(arms.at(0).dot(arms.at(1))) * 180 / std::numbers::pi;
    }
  }
  std::vector<std::pair<double, double>> errors;  // degrees, length
  double whole = 0;
  for (const auto& [regions, sum] : borders)
    for (const auto& [region, angle] : sum.angles) {
      errors.emplace_back(std::abs(angle / sum.length - 120), sum.length);
      whole += sum.length;
    }
  std::ranges::sort(errors);
  double below = 0;
  for (const auto& [error, length] : errors)
    if ((below += length) >= share * whole) return error;
  return 180;
}

TEST(Mcf, CoarsensWithItsWallsInPlace) {
  Tracking tracking = start("mcf", {"cells=12", "dt=0.004"});
  double area = tracking.metrics().area;
  const std::size_t regions = tracking.metrics().regions;
  for (int i = 0; i < 120; ++i) {
    ASSERT_TRUE(step_and_audit(tracking));
    EXPECT_LE(tracking.metrics().area, 1.001 * area) << "step " << tracking.metrics().step;
    EXPECT_NEAR(tracking.metrics().air_area, 6, 1e-12);
    area = tracking.metrics().area;
  }
  EXPECT_LT(tracking.metrics().regions, regions);
  const auto rms = foamsim::junction_angles(without_walls(tracking.mesh())).rms_deviation_deg;
  ASSERT_TRUE(rms.has_value());
  EXPECT_LT(*rms, 15);
}

TEST(Mcf, BordersApproachTheirAnglesAsTheMeshIsRefined) {
  const std::vector<std::pair<Settings, int>> levels{{{"subdivisions=2", "dt=0.001"}, 20},
                                                     {{"subdivisions=3", "dt=0.00025"}, 80}};
  std::vector<double> errors;
  for (auto [settings, steps] : levels) {
    settings.emplace_back("cells=12");
    Tracking tracking = start("mcf", settings);
    for (int i = 0; i < steps; ++i) ASSERT_TRUE(step_and_audit(tracking));
    errors.push_back(border_angle_error(without_walls(tracking.mesh()), 0.5));
    std::cout << tracking.metrics().triangles << " triangles: half of all border has its angles within "
              << errors.back() << " degrees of 120\n";
  }
  for (std::size_t i = 1; i < errors.size(); ++i) EXPECT_LT(errors[i], 0.7 * errors[i - 1]) << "first order";
  EXPECT_LT(errors.back(), 2.2);
}

}  // namespace
}  // namespace multitracker
