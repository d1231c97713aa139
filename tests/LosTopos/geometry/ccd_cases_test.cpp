// Hard cases of continuous collision detection, each by name, with answers known by hand; the exact oracle has to
// agree.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "LosTopos/geometry/ccd.h"
#include "tests/support/ccd_oracle.h"

namespace lostopos::test {
namespace {

using Query = std::array<Trajectory, 4>;

const Vec3 origin(0, 0, 0);

Trajectory at_rest(const Vec3& x) {
  return {x, x};
}
Trajectory moved(const Vec3& x, const Vec3& by) {
  return {x, x + by};
}

std::optional<Collision> vertex_triangle(const Query& q) {
  auto collision = vertex_triangle_collision(q[0], q[1], q[2], q[3]);
  EXPECT_EQ(collision.has_value(), exact_vertex_triangle(q).has_value()) << "against the exact oracle";
  return collision;
}

std::optional<Collision> edge_edge(const Query& q) {
  auto collision = edge_edge_collision(q[0], q[1], q[2], q[3]);
  EXPECT_EQ(collision.has_value(), exact_edge_edge(q).has_value()) << "against the exact oracle";
  return collision;
}

// A vertex against the triangle (0, 0, 0), (1, 0, 0), (0, 1, 0) at rest.
Query against_unit_triangle(const Trajectory& p) {
  return {p, at_rest(origin), at_rest({1, 0, 0}), at_rest({0, 1, 0})};
}

// An edge against the edge from -x to x at rest.
Query against_unit_edge(const Trajectory& a, const Trajectory& b) {
  return {a, b, at_rest({-1, 0, 0}), at_rest({1, 0, 0})};
}

void expect_time(const std::optional<Collision>& c, double time) {
  ASSERT_TRUE(c.has_value());
  EXPECT_LE(c->time, time);
  EXPECT_NEAR(c->time, time, 1e-9);
}

TEST(CcdVertexTriangle, HeadOn) {
  const auto c = vertex_triangle(against_unit_triangle(moved({0.25, 0.5, 1}, {0, 0, -4})));
  expect_time(c, 0.25);
  EXPECT_NEAR(c->weights[0], 1, 1e-12);
  EXPECT_NEAR(c->weights[1], 0.25, 1e-12);
  EXPECT_NEAR(c->weights[2], 0.25, 1e-12);
  EXPECT_NEAR(c->weights[3], 0.5, 1e-12);
  EXPECT_NEAR((c->normal - Vec3::UnitZ()).norm(), 0, 1e-12) << "from the triangle to the vertex";
  EXPECT_NEAR(c->relative_displacement, -4, 1e-12);
}

TEST(CcdVertexTriangle, TriangleMovesOntoRestingVertex) {
  const Vec3 up(0, 0, 2);
  const auto c =
      vertex_triangle({at_rest({0.25, 0.25, 1}), moved(origin, up), moved({1, 0, 0}, up), moved({0, 1, 0}, up)});
  expect_time(c, 0.5);
  EXPECT_NEAR(c->normal.z(), 1, 1e-12);
  EXPECT_NEAR(c->relative_displacement, -2, 1e-12);
}

TEST(CcdVertexTriangle, PassesBesideTheTriangle) {
  EXPECT_FALSE(vertex_triangle(against_unit_triangle(moved({0.6, 0.6, 1}, {0, 0, -2}))));
}

TEST(CcdVertexTriangle, StopsShort) {
  EXPECT_FALSE(vertex_triangle(against_unit_triangle(moved({0.25, 0.25, 1}, {0, 0, -0x1.fffffffffffffp-1}))));
}

TEST(CcdVertexTriangle, GrazesAtTheEndOfTheStep) {
  expect_time(vertex_triangle(against_unit_triangle({{0.25, 0.25, 1}, {0.25, 0.25, 0}})), 1);
}

TEST(CcdVertexTriangle, ContactExactlyAtTheStartMovingAway) {
  const auto c = vertex_triangle(against_unit_triangle({{0.25, 0.25, 0}, {0.25, 0.25, 1}}));
  expect_time(c, 0);
  EXPECT_LE(c->relative_displacement, 0);
}

TEST(CcdVertexTriangle, ZeroLengthMotionInContact) {
  const auto c = vertex_triangle(against_unit_triangle(at_rest({0.25, 0.25, 0})));
  expect_time(c, 0);
  EXPECT_NEAR(std::abs(c->normal.z()), 1, 1e-12);
  EXPECT_EQ(c->relative_displacement, 0);
}

TEST(CcdVertexTriangle, BothAtRestApart) {
  EXPECT_FALSE(vertex_triangle(against_unit_triangle(at_rest({0.25, 0.25, 1}))));
  EXPECT_FALSE(vertex_triangle(against_unit_triangle(at_rest({0.25, 0.25, 1e-13}))));
  EXPECT_FALSE(vertex_triangle(against_unit_triangle(at_rest({-1e-13, 0.25, 0}))));
}

TEST(CcdVertexTriangle, InPlaneMotionIntoTheEdge) {
  const auto c = vertex_triangle(against_unit_triangle(moved({0.5, -1, 0}, {0, 2, 0})));
  expect_time(c, 0.5);
  EXPECT_NEAR((c->normal + Vec3::UnitY()).norm(), 0, 1e-9);
  EXPECT_NEAR(c->relative_displacement, -2, 1e-8);
}

TEST(CcdVertexTriangle, InPlaneMotionPastTheCorner) {
  EXPECT_FALSE(vertex_triangle(against_unit_triangle(moved({2, -1, 0}, {-0.5, 2, 0}))));
  expect_time(vertex_triangle(against_unit_triangle(moved({2, -1, 0}, {-2, 2, 0}))), 0.5);
}

TEST(CcdVertexTriangle, InPlaneMotionInAnObliquePlane) {
  const Trajectory p = moved({-1, 1, 1}, {2, 0, 2});  // all in the plane z = x + y + 1
  EXPECT_TRUE(vertex_triangle({p, at_rest({0, 0, 1}), at_rest({1, 0, 2}), at_rest({0, 2, 3})}));
  EXPECT_FALSE(vertex_triangle({p, at_rest({0, 0, 1}), at_rest({1, 0, 2}), at_rest({0, 0.75, 1.75})}));
}

TEST(CcdVertexTriangle, SlidesAlongTheEdge) {
  expect_time(vertex_triangle(against_unit_triangle(moved({-1, 0, 0}, {3, 0, 0}))), 1.0 / 3);
  expect_time(vertex_triangle(against_unit_triangle(moved({0.25, 0, 0}, {0.5, 0, 0}))), 0);
  EXPECT_FALSE(vertex_triangle(against_unit_triangle(moved({-1, -1e-12, 0}, {3, 0, 0}))));
}

TEST(CcdVertexTriangle, SlidesOverTheFaceWithoutTouching) {
  EXPECT_FALSE(vertex_triangle(against_unit_triangle(moved({-1, 0.25, 1e-12}, {3, 0, 0}))));
}

TEST(CcdVertexTriangle, FastPassThrough) {
  const auto c = vertex_triangle(against_unit_triangle(moved({0.25, 0.25, 1e9}, {0, 0, -4e9})));
  expect_time(c, 0.25);
  EXPECT_FALSE(vertex_triangle(against_unit_triangle(moved({0.5 + 1e-3, 0.5, 1e9}, {0, 0, -4e9}))));
}

// A vertex that crosses a triangle swinging about the y axis: its height over it is (2 t - 1)^2 + z.
Query over_a_swinging_triangle(double z) {
  return Query{Trajectory{{-1, 0, z}, {1, 0, z}}, Trajectory{{-2, -2, -2}, {-2, -2, 2}},
               Trajectory{{-2, 2, -2}, {-2, 2, 2}}, Trajectory{{2, 0, 2}, {2, 0, -2}}};
}

TEST(CcdVertexTriangle, DoubleCrossing) {
  // Through at 1/4 and back at 3/4: a test of the parity of crossings sees nothing.
  expect_time(vertex_triangle(over_a_swinging_triangle(-0.25)), 0.25);
}

TEST(CcdVertexTriangle, TouchesAndTurnsBack) {
  // A double root of the coplanarity cubic.
  const auto c = vertex_triangle(over_a_swinging_triangle(0));
  ASSERT_TRUE(c);
  EXPECT_LE(c->time, 0.5);
  EXPECT_NEAR(c->time, 0.5, 1e-6);
  EXPECT_TRUE(vertex_triangle(over_a_swinging_triangle(-0x1p-1000)));
}

TEST(CcdVertexTriangle, NearlyTouchesAndTurnsBack) {
  EXPECT_FALSE(vertex_triangle(over_a_swinging_triangle(1e-12)));
}

TEST(CcdVertexTriangle, HitsTheCornerExactly) {
  const auto c = vertex_triangle(against_unit_triangle(moved({-1, -2, 1}, {2, 4, -2})));
  expect_time(c, 0.5);
  EXPECT_NEAR(c->weights[1], 1, 1e-9);
}

TEST(CcdVertexTriangle, IdenticalTrajectories) {
  const Trajectory p = moved({0.3, 0.7, 0.1}, {0.1, 0.4, -0.7});
  expect_time(vertex_triangle({p, p, moved({1, 0, 0}, {0, 1, 0}), at_rest({0, 1, 0})}), 0);
  expect_time(vertex_triangle({p, p, p, p}), 0);
}

TEST(CcdVertexTriangle, ParallelTrajectoriesNeverMeet) {
  const Vec3 v(1, -3, 7);
  EXPECT_FALSE(
      vertex_triangle({moved({0.25, 0.25, 1e-10}, v), moved(origin, v), moved({1, 0, 0}, v), moved({0, 1, 0}, v)}));
}

TEST(CcdVertexTriangle, CollapsedTriangles) {
  const Trajectory p = moved({0.5, 0, 1}, {0, 0, -2});
  EXPECT_TRUE(vertex_triangle({p, at_rest(origin), at_rest({1, 0, 0}), at_rest({0.25, 0, 0})})) << "a segment";
  EXPECT_FALSE(vertex_triangle({p, at_rest(origin), at_rest({1, 1, 0}), at_rest({0.25, 0.25, 0})}));
  EXPECT_TRUE(vertex_triangle({p, at_rest({0.5, 0, 0}), at_rest({0.5, 0, 0}), at_rest({0.5, 0, 0})})) << "a point";
  EXPECT_FALSE(vertex_triangle({p, at_rest({0.5, 1e-9, 0}), at_rest({0.5, 1e-9, 0}), at_rest({0.5, 1e-9, 0})}));
  const Query flipping = {at_rest({0.3, 0.3, 0}), Trajectory{{0, 0, 0}, {1, 1, 0}}, Trajectory{{1, 0, 0}, {0, 1, 0}},
                          Trajectory{{0, 1, 0}, {1, 0, 0}}};
  EXPECT_TRUE(vertex_triangle(flipping)) << "in the plane, turned inside out";
}

TEST(CcdVertexTriangle, HugeCommonTranslation) {
  const Vec3 v(0x1p40, -0x1p41, 0x1p42);
  const Vec3 down(0, 0, -1);
  const Query q = {moved({0.25, 0.25, 0.5}, v + down), moved(origin, v), moved({1, 0, 0}, v), moved({0, 1, 0}, v)};
  expect_time(vertex_triangle(q), 0.5);
  const Query beside = {moved({0.5 + 0x1p-10, 0.5, 0.5}, v + down), moved(origin, v), moved({1, 0, 0}, v),
                        moved({0, 1, 0}, v)};
  EXPECT_FALSE(vertex_triangle(beside));
}

TEST(CcdVertexTriangle, ScaleOfTheCoordinatesDoesNotMatter) {
  for (const int exponent : {-1060, -1000, -500, -60, 60, 500, 1000, 1020}) {
    const auto scaled = [exponent](double x, double y, double z) {
      return Vec3(std::ldexp(x, exponent), std::ldexp(y, exponent), std::ldexp(z, exponent));
    };
    const Query through = {Trajectory{scaled(0.25, 0.25, 1), scaled(0.25, 0.25, -1)}, at_rest(scaled(0, 0, 0)),
                           at_rest(scaled(1, 0, 0)), at_rest(scaled(0, 1, 0))};
    expect_time(vertex_triangle(through), 0.5);
    const Query beside = {Trajectory{scaled(0.75, 0.5, 1), scaled(0.75, 0.5, -1)}, at_rest(scaled(0, 0, 0)),
                          at_rest(scaled(1, 0, 0)), at_rest(scaled(0, 1, 0))};
    EXPECT_FALSE(vertex_triangle(beside)) << exponent;
  }
}

TEST(CcdVertexTriangle, DifferencesThatOverflow) {
  const double big = std::numeric_limits<double>::max();
  const Query q = {Trajectory{{0, 0, big}, {0, 0, -big}}, at_rest({-big, -big, 0}), at_rest({big, -big, 0}),
                   at_rest({0, big, 0})};
  const auto c = vertex_triangle(q);
  expect_time(c, 0.5);
  EXPECT_NEAR(c->normal.z(), 1, 1e-12);
}

TEST(CcdEdgeEdge, CrossesInTheMiddle) {
  const Vec3 down(0, 0, -4);
  const auto c = edge_edge(against_unit_edge(moved({0.5, -1, 1}, down), moved({0.5, 3, 1}, down)));
  expect_time(c, 0.25);
  EXPECT_NEAR(c->weights[0], 0.75, 1e-12);
  EXPECT_NEAR(c->weights[1], 0.25, 1e-12);
  EXPECT_NEAR(c->weights[2], 0.25, 1e-12);
  EXPECT_NEAR(c->weights[3], 0.75, 1e-12);
  EXPECT_NEAR((c->normal - Vec3::UnitZ()).norm(), 0, 1e-12) << "from the second edge to the first";
  EXPECT_NEAR(c->relative_displacement, -4, 1e-12);
}

TEST(CcdEdgeEdge, NormalFollowsTheOrderOfTheEdges) {
  const Vec3 down(0, 0, -4);
  const Query q = against_unit_edge(moved({0.5, -1, 1}, down), moved({0.5, 3, 1}, down));
  const auto c = edge_edge({q[2], q[3], q[0], q[1]});
  expect_time(c, 0.25);
  EXPECT_NEAR((c->normal + Vec3::UnitZ()).norm(), 0, 1e-12);
  EXPECT_NEAR(c->relative_displacement, -4, 1e-12);
}

TEST(CcdEdgeEdge, PassesBesideTheEnd) {
  const Vec3 down(0, 0, -4);
  EXPECT_FALSE(edge_edge(against_unit_edge(moved({1.001, -1, 1}, down), moved({1.001, 3, 1}, down))));
}

TEST(CcdEdgeEdge, ParallelEdgesMeet) {
  const Vec3 down(0, 0, -2);
  const auto c = edge_edge(against_unit_edge(moved({-0.5, 0, 1}, down), moved({2, 0, 1}, down)));
  expect_time(c, 0.5);
  EXPECT_NEAR(c->normal.z(), 1, 1e-12);
}

TEST(CcdEdgeEdge, ParallelEdgesPassBesideEachOther) {
  const Vec3 down(0, 0, -2);
  EXPECT_FALSE(edge_edge(against_unit_edge(moved({-0.5, 1e-12, 1}, down), moved({2, 1e-12, 1}, down))));
}

TEST(CcdEdgeEdge, CollinearEdgesMeetEndToEnd) {
  const Vec3 left(-4, 0, 0);
  expect_time(edge_edge(against_unit_edge(moved({3, 0, 0}, left), moved({4, 0, 0}, left))), 0.5);
  EXPECT_FALSE(edge_edge(against_unit_edge(moved({3, 0, 0}, left / 4), moved({4, 0, 0}, left / 4))));
}

TEST(CcdEdgeEdge, InPlaneMotion) {
  const Vec3 up(0, 2, 0);
  expect_time(edge_edge(against_unit_edge(moved({0, -2, 0}, up), moved({0.5, -1, 0}, up))), 0.5);
  EXPECT_FALSE(edge_edge(against_unit_edge(moved({1.5, -2, 0}, up), moved({2.5, -1, 0}, up))));
}

TEST(CcdEdgeEdge, EndTouchesEndAtTheEndOfTheStep) {
  expect_time(edge_edge(against_unit_edge({{2, 1, 1}, {1, 0, 0}}, {{3, 1, 1}, {2, 0, 0}})), 1);
}

TEST(CcdEdgeEdge, ZeroLengthMotion) {
  expect_time(edge_edge(against_unit_edge(at_rest({0, -1, 0}), at_rest({0, 1, 0}))), 0);
  EXPECT_FALSE(edge_edge(against_unit_edge(at_rest({0, -1, 1e-13}), at_rest({0, 1, 1e-13}))));
}

TEST(CcdEdgeEdge, CollapsedEdges) {
  const Trajectory p = moved({0.5, 0, 1}, {0, 0, -2});
  expect_time(edge_edge(against_unit_edge(p, p)), 0.5);
  const Trajectory beside = moved({1.5, 0, 1}, {0, 0, -2});
  EXPECT_FALSE(edge_edge(against_unit_edge(beside, beside)));
  const Trajectory q = at_rest({0.5, 0, 0});
  expect_time(edge_edge({p, p, q, q}), 0.5);
  EXPECT_FALSE(edge_edge({beside, beside, q, q}));
}

TEST(CcdEdgeEdge, IdenticalTrajectories) {
  const Trajectory a = moved({0.3, 0.7, 0.1}, {0.1, 0.4, -0.7});
  const Trajectory b = moved({1.3, 0.2, 0.1}, {0.5, 0.1, 0.9});
  expect_time(edge_edge({a, b, a, b}), 0);
  expect_time(edge_edge({a, b, b, a}), 0);
  expect_time(edge_edge({a, a, a, a}), 0);
}

TEST(CcdEdgeEdge, ScissorsInOnePlane) {
  // Both edges turn in their plane and sweep across each other.
  const Query q = {Trajectory{{-1, 1, 0}, {-1, -1, 0}}, Trajectory{{1, 2, 0}, {1, 0.5, 0}}, at_rest({-1, 0, 0}),
                   Trajectory{{1, 0, 0}, {1, 1, 0}}};
  expect_time(edge_edge(q), 0.5);
}

TEST(CcdEdgeEdge, DoubleCrossing) {
  // As for the vertex over the swinging triangle.
  const auto over_a_swinging_edge = [](double z) {
    return Query{Trajectory{{-1, -1, z}, {1, -1, z}}, Trajectory{{-1, 1, z}, {1, 1, z}},
                 Trajectory{{-2, 0, -2}, {-2, 0, 2}}, Trajectory{{2, 0, 2}, {2, 0, -2}}};
  };
  expect_time(edge_edge(over_a_swinging_edge(-0.25)), 0.25);
  EXPECT_TRUE(edge_edge(over_a_swinging_edge(0)));
  EXPECT_FALSE(edge_edge(over_a_swinging_edge(1e-12)));
}

TEST(CcdEdgeEdge, RigidMotionKeepsTinyGap) {
  const Vec3 v(0.3, -0.2, 0.5);
  EXPECT_FALSE(
      edge_edge({moved({0, -1, 1e-12}, v), moved({0, 1, 1e-12}, v), moved({-1, 0, 0}, v), moved({1, 0, 0}, v)}));
}

}  // namespace
}  // namespace lostopos::test
