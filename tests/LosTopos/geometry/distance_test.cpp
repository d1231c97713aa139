#include "LosTopos/geometry/distance.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace lostopos::test {
namespace {

class RandomPoints {
 public:
  explicit RandomPoints(std::uint64_t seed) : bits_(seed) {}
  double uniform(double low, double high) {
    return low + (high - low) * (static_cast<double>(bits_() >> 11) * 0x1p-53);
  }
  Vec3 point() {
    const double x = uniform(-1, 1);
    const double y = uniform(-1, 1);
    return {x, y, uniform(-1, 1)};
  }
  // Drawn in this order, which arguments of a call are not with every compiler.
  std::array<Vec3, 4> four_points() { return {point(), point(), point(), point()}; }
  int integer(int n) { return static_cast<int>(bits_() % static_cast<std::uint64_t>(n)); }

 private:
  std::mt19937_64 bits_;
};

// A lower bound of the distance of two hulls by separation along a direction; equality proves a distance minimal.
double separation(const std::vector<Vec3>& p, const std::vector<Vec3>& q, const Vec3& direction) {
  double p_low = HUGE_VAL;
  double q_high = -HUGE_VAL;
  for (const Vec3& x : p) p_low = std::min(p_low, direction.dot(x - q[0]));
  for (const Vec3& x : q) q_high = std::max(q_high, direction.dot(x - q[0]));
  return p_low - q_high;
}

// The distance is attained by the offset; and no smaller one is possible, unless it is rounding. The offset is rounded
// as the points are, which turns its direction by as much over the distance.
void expect_minimal(double distance, const Vec3& offset, const std::vector<Vec3>& p, const std::vector<Vec3>& q,
                    double tolerance) {
  EXPECT_NEAR(distance, offset.norm(), 1e-15 * distance);
  if (distance < tolerance) return;
  EXPECT_NEAR(separation(p, q, offset / distance), distance, tolerance + 1e-15 / distance);
}

void check_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c, double tolerance) {
  const auto d = point_triangle_distance(p, a, b, c);
  EXPECT_GE(d.weights.minCoeff(), 0);
  EXPECT_NEAR(d.weights.sum(), 1, 1e-15);
  const Vec3 closest = d.weights[0] * a + d.weights[1] * b + d.weights[2] * c;
  EXPECT_LT((p - closest - d.offset).norm(), 1e-14);
  expect_minimal(d.distance, d.offset, {p}, {a, b, c}, tolerance);
}

void check_segments(const Vec3& p0, const Vec3& p1, const Vec3& q0, const Vec3& q1, double tolerance) {
  const auto d = segment_segment_distance(p0, p1, q0, q1);
  EXPECT_TRUE(d.s >= 0 && d.s <= 1 && d.t >= 0 && d.t <= 1);
  EXPECT_LT((p0 + d.s * (p1 - p0) - q0 - d.t * (q1 - q0) - d.offset).norm(), 1e-14);
  expect_minimal(d.distance, d.offset, {p0, p1}, {q0, q1}, tolerance);
}

TEST(PointTriangle, KnownRegions) {
  const Vec3 a(0, 0, 0);
  const Vec3 b(1, 0, 0);
  const Vec3 c(0, 1, 0);
  const auto face = point_triangle_distance({0.25, 0.25, -2}, a, b, c);
  EXPECT_DOUBLE_EQ(face.distance, 2);
  EXPECT_EQ(face.weights, Vec3(0.5, 0.25, 0.25));
  EXPECT_EQ(face.offset, Vec3(0, 0, -2));
  const auto edge = point_triangle_distance({1, 1, 0}, a, b, c);
  EXPECT_DOUBLE_EQ(edge.distance, std::sqrt(0.5));
  EXPECT_EQ(edge.weights, Vec3(0, 0.5, 0.5));
  const auto corner = point_triangle_distance({-3, -4, 0}, a, b, c);
  EXPECT_DOUBLE_EQ(corner.distance, 5);
  EXPECT_EQ(corner.weights, Vec3(1, 0, 0));
  const auto on_it = point_triangle_distance({0.25, 0.5, 0}, a, b, c);
  EXPECT_EQ(on_it.distance, 0);
}

TEST(PointTriangle, IsMinimalForRandomTriangles) {
  RandomPoints random(1);
  for (int i = 0; i < 20000; ++i) {
    const auto [p, a, b, c] = random.four_points();
    check_triangle(p, a, b, c, 1e-11);
  }
}

TEST(PointTriangle, IsMinimalForSliversAndCollapsedTriangles) {
  RandomPoints random(2);
  for (int i = 0; i < 20000; ++i) {
    const Vec3 a = random.point();
    const Vec3 b = i % 7 == 0 ? a : random.point();
    const double width = i % 3 == 0 ? 0 : std::pow(10.0, -random.integer(20));
    const Vec3 c = a + random.uniform(-1, 2) * (b - a) + width * random.point();
    check_triangle(random.point(), a, b, c, 1e-9);
    check_triangle(random.point(), c, a, b, 1e-9);
  }
}

TEST(PointTriangle, CollapsedToAPoint) {
  const Vec3 a(1, 2, 3);
  const auto d = point_triangle_distance({1, 2, 5}, a, a, a);
  EXPECT_EQ(d.distance, 2);
  EXPECT_EQ(d.weights.sum(), 1);
  EXPECT_EQ(point_triangle_distance(a, a, a, a).distance, 0);
}

TEST(PointTriangle, ScalesWithTheCoordinates) {
  const Vec3 p(0.3, 0.2, 0.7);
  const Vec3 b(1, 0.1, 0);
  const Vec3 c(0.2, 1, 0.3);
  const auto d = point_triangle_distance(p, Vec3::Zero(), b, c);
  for (const int exponent : {-1000, -300, 300, 1000}) {
    const double k = std::ldexp(1.0, exponent);
    const auto scaled = point_triangle_distance(k * p, Vec3::Zero(), k * b, k * c);
    EXPECT_DOUBLE_EQ(scaled.distance / k, d.distance);
    EXPECT_LT((scaled.weights - d.weights).norm(), 1e-15);
  }
}

TEST(SegmentSegment, KnownPositions) {
  const auto crossing = segment_segment_distance({-1, 0, 1}, {3, 0, 1}, {0, -1, 0}, {0, 1, 0});
  EXPECT_DOUBLE_EQ(crossing.distance, 1);
  EXPECT_DOUBLE_EQ(crossing.s, 0.25);
  EXPECT_DOUBLE_EQ(crossing.t, 0.5);
  EXPECT_EQ(crossing.offset, Vec3(0, 0, 1));
  const auto parallel = segment_segment_distance({0, 0, 0}, {1, 0, 0}, {0.5, 2, 0}, {3, 2, 0});
  EXPECT_DOUBLE_EQ(parallel.distance, 2);
  const auto in_line = segment_segment_distance({0, 0, 0}, {1, 0, 0}, {3, 0, 0}, {2, 0, 0});
  EXPECT_DOUBLE_EQ(in_line.distance, 1);
  EXPECT_EQ(in_line.s, 1);
  EXPECT_EQ(in_line.t, 1);
  const auto points = segment_segment_distance({0, 0, 0}, {0, 0, 0}, {3, 4, 0}, {3, 4, 0});
  EXPECT_DOUBLE_EQ(points.distance, 5);
}

TEST(SegmentSegment, IsMinimalForRandomSegments) {
  RandomPoints random(3);
  for (int i = 0; i < 20000; ++i) {
    const auto [p0, p1, q0, q1] = random.four_points();
    check_segments(p0, p1, q0, q1, 1e-11);
  }
}

TEST(SegmentSegment, IsMinimalForNearlyParallelAndCollapsedSegments) {
  RandomPoints random(4);
  for (int i = 0; i < 20000; ++i) {
    const Vec3 p0 = random.point();
    const Vec3 p1 = i % 5 == 0 ? p0 : random.point();
    const Vec3 q0 = random.point();
    const double angle = i % 3 == 0 ? 0 : std::pow(10.0, -random.integer(20));
    const Vec3 q1 = i % 7 == 0 ? q0 : Vec3(q0 + random.uniform(-2, 2) * (p1 - p0) + angle * random.point());
    check_segments(p0, p1, q0, q1, 1e-9);
    check_segments(q0, q1, p0, p1, 1e-9);
  }
}

TEST(PointSegment, KnownPositions) {
  const auto inside = point_segment_distance({0.25, 3, 4}, {0, 0, 0}, {1, 0, 0});
  EXPECT_DOUBLE_EQ(inside.distance, 5);
  EXPECT_DOUBLE_EQ(inside.t, 0.25);
  EXPECT_EQ(point_segment_distance({7, 0, 0}, {0, 0, 0}, {1, 0, 0}).t, 1);
  EXPECT_EQ(point_segment_distance({7, 0, 0}, {1, 0, 0}, {1, 0, 0}).distance, 6) << "of zero length";
}

}  // namespace
}  // namespace lostopos::test
