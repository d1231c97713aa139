#include "LosTopos/remeshing/remesher.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>

#include "Base/error.h"
#include "FoamSim/scenes/shapes/double_bubble.h"
#include "LosTopos/geometry/triangle_quality.h"
#include "LosTopos/mesh/audit.h"
#include "LosTopos/mesh/measures.h"
#include "tests/LosTopos/remeshing/patches.h"
#include "tests/support/film_meshes.h"
#include "tests/support/sample_meshes.h"

namespace lostopos {
namespace {

constexpr double degree = std::numbers::pi / 180;

double mean_rim_radius(const SurfaceMesh& mesh) {
  double sum = 0, count = 0;
  for (Vertex v : mesh.vertices())
    if (mesh.is_junction(v)) {
      sum += mesh.position(v).tail<2>().norm();
      ++count;
    }
  return sum / count;
}

std::size_t edges_out_of_bounds(const SurfaceMesh& mesh, double h) {
  std::size_t out = 0;
  for (Edge e : mesh.edges()) out += length(mesh, e) < 0.5 * h || length(mesh, e) > 1.5 * h;
  return out;
}

// Prints how many angles there are in each stretch of ten degrees; returns the smallest and the largest in degrees.
std::array<double, 2> angle_histogram(const SurfaceMesh& mesh) {
  std::array<int, 18> histogram{};
  double low = 180, high = 0;
  for (Triangle t : mesh.triangles()) {
    const auto [a, b, c] = corners(mesh, t);
    for (double angle : Vec3(triangle_angles(a, b, c) / degree)) {
      ++histogram[std::min<std::size_t>(17, static_cast<std::size_t>(angle / 10))];
      low = std::min(low, angle);
      high = std::max(high, angle);
    }
  }
  std::printf("angles by tens of degrees:");
  for (int count : histogram) std::printf(" %d", count);
  std::printf("; %.1f to %.1f degrees\n", low, high);
  return {low, high};
}

// `share_out`: of edges that may be out of bounds.
void expect_well_shaped(const SurfaceMesh& mesh, double h, double share_out) {
  const auto [low, high] = angle_histogram(mesh);
  EXPECT_GT(low, 15);
  EXPECT_LT(high, 150);
  EXPECT_LE(static_cast<double>(edges_out_of_bounds(mesh, h)), share_out * static_cast<double>(mesh.edge_count()));
}

void rest_for_100_rounds(SurfaceMesh mesh) {
  const auto volumes = region_volumes(mesh);
  const double rim = mean_rim_radius(mesh), h = mean_edge_length(mesh);
  auto held = mesh.add_vertex_attribute<Hold>(Hold::none);
  RemeshOptions options;
  options.target_edge = h;
  Remesher remesher(mesh, held, options);
  for (int round = 0; round < 100; ++round) {
    const RemeshStatistics done = remesher.run();
    if (round == 99) {
      EXPECT_LT(done.done_in_all(), 5U) << "it comes to rest";
    }
  }
  EXPECT_EQ(audit(mesh).text(), "clean");
  for (const auto& [region, before] : volumes)
    EXPECT_LT(std::abs(test::volume(mesh, region) / before - 1), 1e-3) << "region " << region.index();
  EXPECT_LT(std::abs(mean_rim_radius(mesh) / rim - 1), 2e-3);
  expect_well_shaped(mesh, h, 1e-3);
}

TEST(RemeshingAtRest, AnalyticDoubleBubble) {
  rest_for_100_rounds(test::analytic_double_bubble(1, 24));
}

TEST(RemeshingAtRest, DoubleBubbleOfMeridiansWithPoles16) {
  rest_for_100_rounds(foamsim::double_bubble(16));
}

TEST(RemeshingAtRest, DoubleBubbleOfMeridiansWithPoles24) {
  rest_for_100_rounds(foamsim::double_bubble(24));
}

TEST(Remesher, AQuietPassChangesNotOneBit) {
  SurfaceMesh mesh = test::analytic_double_bubble(1, 16);
  auto held = mesh.add_vertex_attribute<Hold>(Hold::none);
  RemeshOptions options;
  options.target_edge = mean_edge_length(mesh);
  const auto before = mesh.state();
  const RemeshStatistics statistics = Remesher(mesh, held, options).run();
  EXPECT_EQ(statistics.done_in_all(), 0U);
  EXPECT_EQ(statistics.too_long.total() + statistics.too_short.total(), 0U);
  EXPECT_TRUE(test::same_bits(before, mesh.state()));
}

// Stretches the double bubble to three times its length and back by maps that keep volumes and cannot make the surface
// intersect itself; all that changes volumes is remeshing.
void stretch_and_remesh(SurfaceMesh& mesh, const RemeshOptions& options, int steps, NearTriangles* index = nullptr) {
  auto held = mesh.add_vertex_attribute<Hold>(Hold::none);
  Remesher remesher(mesh, held, options);
  for (int i = 0; i < steps; ++i) {
    const double f = i < steps / 2 ? 1.04 : 1 / 1.04;
    for (Vertex v : mesh.vertices()) {
      const Vec3& x = mesh.position(v);
      mesh.set_position(v, Vec3(x[0] / std::sqrt(f), x[1] * f, x[2] / std::sqrt(f)));
    }
    const RemeshStatistics statistics = remesher.run(index);
    EXPECT_EQ(statistics.too_long.total() + statistics.too_short.total(),
              edges_out_of_bounds(mesh, options.target_edge));
    EXPECT_EQ(statistics.triangles_out_of_bounds, 0U);
    if (i % 10 == 9) {
      ASSERT_EQ(audit(mesh).text(), "clean") << "step " << i;
    }
  }
}

TEST(Remesher, FollowsALargeDeformationAndKeepsTheVolumes) {
  SurfaceMesh mesh = test::analytic_double_bubble(1, 20);
  const auto volumes = region_volumes(mesh);
  RemeshOptions options;
  options.target_edge = mean_edge_length(mesh);
  stretch_and_remesh(mesh, options, 60);
  for (const auto& [region, before] : volumes) EXPECT_NEAR(test::volume(mesh, region) / before, 1, 3e-4);
  EXPECT_EQ(euler_characteristic(mesh), 3);
  expect_well_shaped(mesh, options.target_edge, 5e-3);
}

// Slots that are not in use hold old values, which may differ.
void expect_same_when_compacted(const SurfaceMesh& a, const SurfaceMesh& b) {
  SurfaceMesh x = a.clone(), y = b.clone();
  x.compact();
  y.compact();
  EXPECT_TRUE(test::same_bits(x.state(), y.state()));
}

TEST(Remesher, GivesTheSameBitsWithAGivenIndexAndOtherLabels) {
  RemeshOptions options;
  options.target_edge = mean_edge_length(test::analytic_double_bubble(1, 12));
  SurfaceMesh plain = test::analytic_double_bubble(1, 12), indexed = plain.clone(), relabelled = plain.clone();
  auto renamed = [](Region r) { return r == air ? air : Region(r.index() + 5000); };
  for (Triangle t : relabelled.triangles()) {
    const Labels l = relabelled.labels(t);
    relabelled.set_labels(t, {renamed(l.p), renamed(l.q)});
  }
  NearTriangles index({.reach = 0.05 * options.target_edge, .slack = 0.1 * options.target_edge});
  stretch_and_remesh(plain, options, 20);
  stretch_and_remesh(indexed, options, 20, &index);
  stretch_and_remesh(relabelled, options, 20);
  EXPECT_TRUE(test::same_bits(plain.state(), indexed.state()));
  for (Triangle t : relabelled.triangles()) {
    ASSERT_EQ(relabelled.labels(t).p, renamed(plain.labels(t).p));
    relabelled.set_labels(t, plain.labels(t));
  }
  expect_same_when_compacted(plain, relabelled);
}

TEST(Remesher, DoesNotDependOnTheUnitOfLength) {
  const SurfaceMesh start = test::analytic_double_bubble(1, 12);
  RemeshOptions options;
  options.target_edge = mean_edge_length(start);
  SurfaceMesh plain = start.clone();
  stretch_and_remesh(plain, options, 20);
  for (double unit : {0x1p-30, 0x1p+20}) {
    SurfaceMesh scaled = start.clone();
    for (Vertex v : scaled.vertices()) scaled.set_position(v, unit * start.position(v));
    RemeshOptions scaled_options = options;
    scaled_options.target_edge *= unit;
    stretch_and_remesh(scaled, scaled_options, 20);
    for (Vertex v : scaled.vertices()) scaled.set_position(v, scaled.position(v) / unit);
    expect_same_when_compacted(plain, scaled);
  }
}

TEST(Remesher, RefinesAndCoarsensToTheAskedResolution) {
  for (double factor : {0.5, 2.0}) {
    SurfaceMesh mesh = test::analytic_double_bubble(1, 32);
    RemeshOptions options;
    options.target_edge = factor * mean_edge_length(mesh);
    auto held = mesh.add_vertex_attribute<Hold>(Hold::none);
    const auto volumes = region_volumes(mesh);
    Remesher remesher(mesh, held, options);
    for (int round = 0; round < 10; ++round) remesher.run();
    EXPECT_EQ(audit(mesh).text(), "clean");
    EXPECT_EQ(euler_characteristic(mesh), 3);
    for (const auto& [region, before] : volumes) EXPECT_NEAR(test::volume(mesh, region) / before, 1, 1e-3);
    expect_well_shaped(mesh, options.target_edge, 5e-3);
  }
}

TEST(Remesher, MendsSliversByAggressiveRounds) {
  // A vertex of a fine sphere pushed along the surface until it almost touches the far side of its star.
  SurfaceMesh mesh = test::globe(1, 10);
  const Vertex v(95), towards(96);
  mesh.set_position(v, 0.02 * mesh.position(v) + 0.98 * mesh.position(towards));
  ASSERT_EQ(audit(mesh).text(), "clean");
  RemeshOptions options;
  options.target_edge = 0.3;
  auto held = mesh.add_vertex_attribute<Hold>(Hold::none);
  const RemeshStatistics statistics = Remesher(mesh, held, options).run();
  EXPECT_EQ(statistics.triangles_out_of_bounds, 0U);
  EXPECT_EQ(audit(mesh).text(), "clean");
}

TEST(Remesher, LeavesHeldVerticesInPlaceAndCountsWhatTheyHinder) {
  auto cube = test::cube_frame(6);
  SurfaceMesh& mesh = cube.mesh;
  auto held = mesh.add_vertex_attribute<Hold>(Hold::none);
  for (Vertex v : cube.frame) held[v] = Hold::all;
  const std::vector<Vec3> before(mesh.positions().begin(), mesh.positions().end());
  RemeshOptions options;
  options.target_edge = 0.5 * mean_edge_length(mesh);
  Remesher remesher(mesh, held, options);
  RemeshStatistics last;
  for (int round = 0; round < 5; ++round) last = remesher.run();
  for (Vertex v : cube.frame) {
    ASSERT_TRUE(mesh.alive(v));
    EXPECT_EQ(mesh.position(v), before[v.index()]);
  }
  EXPECT_EQ(audit(mesh, {.closed_regions = false}).text(), "clean");
  EXPECT_EQ(last.too_long.refused[static_cast<std::size_t>(Refusal::held)], 12U * 6);
  EXPECT_EQ(last.too_long.total() + last.too_short.total(), edges_out_of_bounds(mesh, options.target_edge));
}

TEST(Remesher, SaysWhatIsWrongWithItsOptions) {
  SurfaceMesh mesh = test::corner_tetrahedron();
  auto held = mesh.add_vertex_attribute<Hold>(Hold::none);
  RemeshOptions options;
  EXPECT_THROW(Remesher(mesh, held, options), base::InputError);
  options.target_edge = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(Remesher(mesh, held, options), base::InputError);
  options.target_edge = 1;
  EXPECT_NO_THROW(Remesher(mesh, held, options));
  options.shortest_edge = 0.8;
  EXPECT_THROW(Remesher(mesh, held, options), base::InputError);
}

}  // namespace
}  // namespace lostopos
