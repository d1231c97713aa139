#include "LosTopos/topology/vertex_separation.h"

#include <gtest/gtest.h>

#include "LosTopos/mesh/audit.h"
#include "LosTopos/mesh/measures.h"
#include "LosTopos/shapes/voronoi_foam.h"
#include "LosTopos/topology/topology_pass.h"
#include "tests/LosTopos/remeshing/patches.h"
#include "tests/LosTopos/topology/clusters.h"
#include "tests/support/film_meshes.h"

namespace lostopos {
namespace {

std::vector<Vertex> incomplete_vertices(const SurfaceMesh& mesh) {
  std::vector<Vertex> list;
  for (Vertex v : mesh.vertices())
    if (!is_complete(mesh, v)) list.push_back(v);
  return list;
}

// Separates until all vertices are complete; the surface is audited after every one. Returns how many it took.
int separate_all(RemeshContext& context, VertexSeparation& separation, bool closed) {
  constexpr int most = 100;
  for (int done = 0; done < most; ++done) {
    const auto list = incomplete_vertices(context.mesh);
    if (list.empty()) return done;
    bool any = false;
    for (Vertex v : list)
      if (!separation.attempt(v)) {
        any = true;
        break;
      }
    EXPECT_TRUE(any) << list.size() << " vertices cannot be separated";
    if (!any) return done;
    EXPECT_EQ(audit(context.mesh, {.closed_regions = closed}).text(), "clean");
  }
  return most;
}

// Where four borders and more meet at a point of a foam, the films' tension opens it.
TEST(VertexSeparation, PointsOfAFoamWhereTooManyBordersMeetOpenAndSaveArea) {
  std::size_t opened = 0, points = 0;
  for (std::uint64_t seed : {1u, 2u, 3u}) {
    SurfaceMesh mesh = voronoi_foam({.cells = 30, .seed = seed, .shortest_side = 0.3});
    auto held = mesh.add_vertex_attribute<Hold>(Hold::none);
    RemeshContext context(mesh, held, test::wide_bounds());
    VertexSeparation separation(context, SeparationRule::area, 0.03, {});
    for (Vertex v : incomplete_vertices(mesh)) {
      ++points;
      const double before = total_area(mesh);
      if (separation.attempt(v)) continue;
      ++opened;
      EXPECT_LT(total_area(mesh), before);
      EXPECT_GE(separation.regions().size(), 2u);
      ASSERT_EQ(audit(mesh).text(), "clean");
    }
  }
  EXPECT_GT(points, 10u);
  EXPECT_GT(opened, points / 2);
}

// Off the middle of a cube frame, as in it, nothing is gained by parting two of the six regions: the point stays.
TEST(VertexSeparation, WhatWouldNotSaveAreaStays) {
  auto cube = test::cube_frame(4);
  auto held = cube.mesh.add_vertex_attribute<Hold>(Hold::none);
  RemeshContext context(cube.mesh, held, test::wide_bounds());
  const auto before = cube.mesh.state();
  EXPECT_EQ(VertexSeparation(context, SeparationRule::area, 0.05, {}).attempt(Vertex(0)), Refusal::not_better);
  EXPECT_TRUE(test::same_bits(before, cube.mesh.state()));
}

// The flow decides which of the two pairs of opposite columns comes together.
class FourColumns : public testing::TestWithParam<bool> {};

TEST_P(FourColumns, TheLineBecomesTwoTripleLines) {
  const bool along_diagonal = GetParam();
  SurfaceMesh mesh = test::four_columns({Region(1), Region(2), Region(3), Region(4)});
  auto held = mesh.add_vertex_attribute<Hold>(Hold::none);
  RemeshContext context(mesh, held, test::wide_bounds());
  // Region 1 is at (1, 1), 3 opposite; the flow parts these, or regions 2 and 4.
  const Vec3 axis = Vec3(1, along_diagonal ? 1 : -1, 0).normalized();
  auto flow = [&](Vertex v) -> Vec3 { return axis * axis.dot(mesh.position(v)); };
  VertexSeparation separation(context, SeparationRule::flow, 0.1, flow);
  EXPECT_GT(separate_all(context, separation, true), 2);
  EXPECT_TRUE(test::all_complete(mesh));
  const double film13 = test::film_area(mesh, Region(1), Region(3)),
               film24 = test::film_area(mesh, Region(2), Region(4));
  EXPECT_GT(along_diagonal ? film24 : film13, 0.05);
  EXPECT_EQ(along_diagonal ? film13 : film24, 0);
  std::size_t of_three = 0, of_four = 0;
  for (Edge e : mesh.edges()) {
    of_three += mesh.triangles(e).size() == 3;
    of_four += mesh.triangles(e).size() > 3;
  }
  EXPECT_GT(of_three, 4u);
  EXPECT_EQ(of_four, 0u);
}
INSTANTIATE_TEST_SUITE_P(BothWays, FourColumns, testing::Bool());

TEST(VertexSeparation, AFlowThatConvergesSeparatesNothing) {
  SurfaceMesh mesh = test::four_columns({Region(1), Region(2), Region(3), Region(4)});
  auto held = mesh.add_vertex_attribute<Hold>(Hold::none);
  RemeshContext context(mesh, held, test::wide_bounds());
  auto flow = [&](Vertex v) -> Vec3 { return -mesh.position(v); };
  VertexSeparation separation(context, SeparationRule::flow, 0.1, flow);
  const auto before = mesh.state();
  for (Vertex v : incomplete_vertices(mesh)) EXPECT_EQ(separation.attempt(v), Refusal::not_better);
  EXPECT_TRUE(test::same_bits(before, mesh.state()));
}

// What is left after a pass is told by what kept it so.
TEST(VertexSeparation, VerticesThatStayIncompleteAreCountedByTheReason) {
  for (const bool hold_some : {false, true}) {
    SurfaceMesh mesh = test::four_columns({Region(1), Region(2), Region(3), Region(4)});
    auto held = mesh.add_vertex_attribute<Hold>(Hold::none);
    const std::vector<Vertex> incomplete = incomplete_vertices(mesh);
    ASSERT_GT(incomplete.size(), 2u);
    if (hold_some) held[incomplete.front()] = Hold::all;
    RemeshContext context(mesh, held, test::wide_bounds());
    TopologyOptions options;
    options.separation = SeparationRule::flow;
    TopologyStatistics statistics;
    TopologyPass pass(
        context, options, [&](Vertex v) -> Vec3 { return -mesh.position(v); }, statistics);
    pass.separate_vertices();
    pass.count_what_is_left();
    const auto left_by = [&](Refusal r) { return statistics.incomplete_by_refusal[static_cast<std::size_t>(r)]; };
    EXPECT_EQ(statistics.incomplete_vertices, incomplete.size());
    EXPECT_EQ(left_by(Refusal::held), hold_some ? 1u : 0u);
    EXPECT_EQ(left_by(Refusal::not_better), incomplete.size() - (hold_some ? 1 : 0));
  }
}

TEST(VertexSeparation, HeldVerticesAreNotSeparated) {
  auto cube = test::cube_frame(2);
  auto held = cube.mesh.add_vertex_attribute<Hold>(Hold::none);
  held[Vertex(0)] = Hold::all;
  RemeshContext context(cube.mesh, held, test::wide_bounds());
  const auto before = cube.mesh.state();
  EXPECT_EQ(VertexSeparation(context, SeparationRule::area, 0.1, {}).attempt(Vertex(0)), Refusal::held);
  EXPECT_TRUE(test::same_bits(before, cube.mesh.state()));
}

}  // namespace
}  // namespace lostopos
