#include "LosTopos/geometry/predicates.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

namespace lostopos::test {
namespace {

using Rational = boost::multiprecision::cpp_rational;

int sign(const Rational& x) {
  return x.sign();
}

// By Laplace expansion of the 4 x 4 determinant with a column of ones, in rationals.
int exact_orient3d(const std::array<Vec3, 4>& p) {
  const auto minor = [&p](int i, int j, int k) {
    const auto at = [&p](int row, int column) { return Rational(p[static_cast<std::size_t>(row)][column]); };
    return Rational(at(i, 0) * (at(j, 1) * at(k, 2) - at(j, 2) * at(k, 1)) -
                    at(i, 1) * (at(j, 0) * at(k, 2) - at(j, 2) * at(k, 0)) +
                    at(i, 2) * (at(j, 0) * at(k, 1) - at(j, 1) * at(k, 0)));
  };
  return sign(minor(1, 2, 3) - minor(0, 2, 3) + minor(0, 1, 3) - minor(0, 1, 2));
}

int exact_orient2d(const Vec2& a, const Vec2& b, const Vec2& c) {
  const auto product = [](double x, double y) { return Rational(Rational(x) * Rational(y)); };
  return sign(product(a.x(), b.y()) - product(a.y(), b.x()) + product(b.x(), c.y()) - product(b.y(), c.x()) +
              product(c.x(), a.y()) - product(c.y(), a.x()));
}

class Random {
 public:
  explicit Random(std::uint64_t seed) : bits_(seed) {}
  int integer(int low, int high) {
    return low + static_cast<int>(bits_() % static_cast<std::uint64_t>(high - low + 1));
  }
  double uniform() { return static_cast<double>(bits_() >> 11) * 0x1p-53; }
  Vec3 grid_point(int n) {
    const int x = integer(0, n);
    const int y = integer(0, n);
    return Vec3(x, y, integer(0, n));
  }
  Vec3 point() {
    const double x = uniform();
    const double y = uniform();
    return {x, y, uniform()};
  }

 private:
  std::mt19937_64 bits_;
};

TEST(Orient3d, SignConvention) {
  EXPECT_EQ(orient3d({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}), 1);
  EXPECT_EQ(orient3d({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}), -1);
  EXPECT_EQ(orient3d({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {7, -3, 0}), 0);
}

TEST(Orient2d, SignConvention) {
  EXPECT_EQ(orient2d({0, 0}, {1, 0}, {0, 1}), 1);
  EXPECT_EQ(orient2d({0, 0}, {0, 1}, {1, 0}), -1);
  EXPECT_EQ(orient2d({0, 0}, {1, 1}, {3, 3}), 0);
}

TEST(Orient3d, AgreesWithRationalsNearCoplanar) {
  Random random(1);
  int zeros = 0;
  for (int i = 0; i < 3000; ++i) {
    std::array<Vec3, 4> p = {random.point(), random.point(), random.point(), {}};
    const double s = random.uniform();
    const double t = random.uniform();
    p[3] = p[0] + s * (p[1] - p[0]) + t * (p[2] - p[0]);
    if (i % 3 == 0) {
      for (Vec3& x : p) x.z() = 3 * x.x() + 2 * x.y();
    }
    if (i % 5 == 0) {
      for (Vec3& x : p) x = (x * 16).array().round() * 0.1;
    }
    const int expected = exact_orient3d(p);
    zeros += expected == 0 ? 1 : 0;
    EXPECT_EQ(orient3d(p[0], p[1], p[2], p[3]), expected);
    EXPECT_EQ(orient3d(p[1], p[0], p[2], p[3]), -expected);
    EXPECT_EQ(orient3d(p[1], p[2], p[0], p[3]), expected);
  }
  EXPECT_GT(zeros, 10);
}

TEST(Orient3d, AgreesWithRationalsAtAllScales) {
  Random random(2);
  for (int i = 0; i < 300; ++i) {
    std::array<Vec3, 4> p;
    for (Vec3& x : p) {
      for (int k = 0; k < 3; ++k) x[k] = std::ldexp(random.uniform() - 0.5, random.integer(-1074, 1024));
    }
    EXPECT_EQ(orient3d(p[0], p[1], p[2], p[3]), exact_orient3d(p));
  }
}

TEST(Orient3d, AgreesWithRationalsOnDenormals) {
  Random random(3);
  const double least = std::numeric_limits<double>::denorm_min();
  for (int i = 0; i < 500; ++i) {
    std::array<Vec3, 4> p;
    for (Vec3& x : p) x = least * random.grid_point(3);
    const Vec3 far(0x1p900 * (i % 2), 0, 0);
    p[0] += far;
    EXPECT_EQ(orient3d(p[0], p[1], p[2], p[3]), exact_orient3d(p));
  }
}

TEST(Orient3d, LargestCoordinates) {
  const double big = std::numeric_limits<double>::max();
  EXPECT_EQ(orient3d({-big, -big, -big}, {big, -big, -big}, {-big, big, -big}, {-big, -big, big}), 1);
  EXPECT_EQ(orient3d({-big, -big, -big}, {big, -big, -big}, {-big, big, -big}, {big, big, -big}), 0);
}

TEST(Orient2d, AgreesWithRationals) {
  Random random(4);
  for (int i = 0; i < 5000; ++i) {
    std::array<Vec2, 3> p;
    for (Vec2& x : p) x = {random.uniform(), random.uniform()};
    if (i % 2 == 0) p[2] = p[0] + random.uniform() * (p[1] - p[0]);
    if (i % 3 == 0) {
      for (Vec2& x : p)
        x = {std::ldexp(x.x(), random.integer(-1070, 1023)), std::ldexp(x.y(), random.integer(-1070, 1023))};
    }
    EXPECT_EQ(orient2d(p[0], p[1], p[2]), exact_orient2d(p[0], p[1], p[2]));
  }
}

// Whether the origin is in the hull of points with small integer coordinates: by Caratheodory's theorem, in that of one
// of their simplices of at most four corners.
class HullOracle {
 public:
  using Point = Eigen::Matrix<std::int64_t, 3, 1>;

  void add(const Vec3& p) { points_.push_back(p.cast<std::int64_t>()); }

  bool holds_origin() const {
    const std::size_t n = points_.size();
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = i; j < n; ++j) {
        if (in_segment(points_[i], points_[j])) return true;
        for (std::size_t k = j + 1; k < n; ++k) {
          if (in_triangle(points_[i], points_[j], points_[k])) return true;
          for (std::size_t l = k + 1; l < n; ++l) {
            if (in_tetrahedron(points_[i], points_[j], points_[k], points_[l])) return true;
          }
        }
      }
    }
    return false;
  }

 private:
  static std::int64_t determinant(const Point& a, const Point& b, const Point& c) { return a.cross(b).dot(c); }
  static bool same_sign(std::initializer_list<std::int64_t> values) {
    return std::min(values) >= 0 || std::max(values) <= 0;
  }

  static bool in_segment(const Point& a, const Point& b) { return a.cross(b).isZero() && a.dot(b) <= 0; }
  static bool in_triangle(const Point& a, const Point& b, const Point& c) {
    const Point n = (b - a).cross(c - a);
    if (n.isZero() || n.dot(a) != 0) return false;
    return same_sign({n.dot(a.cross(b)), n.dot(b.cross(c)), n.dot(c.cross(a))});
  }
  static bool in_tetrahedron(const Point& a, const Point& b, const Point& c, const Point& d) {
    if (determinant(b - a, c - a, d - a) == 0) return false;
    return same_sign({determinant(b, c, d), -determinant(a, c, d), determinant(a, b, d), -determinant(a, b, c)});
  }

  std::vector<Point> points_;
};

bool hulls_meet(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  HullOracle oracle;
  for (const Vec3& x : a) {
    for (const Vec3& y : b) oracle.add(x - y);
  }
  return oracle.holds_origin();
}

// In integers: the segment's line meets the plane in one point, inside both.
bool crosses_properly(const std::array<Vec3, 5>& p) {
  const Vec3 n = (p[3] - p[2]).cross(p[4] - p[2]);
  const double side0 = n.dot(p[0] - p[2]);
  const double side1 = n.dot(p[1] - p[2]);
  if (side0 * side1 >= 0) return false;
  // The crossing times (side0 - side1), relative to the corners times the same.
  const double whole = side0 - side1;
  const Vec3 x = side0 * p[1] - side1 * p[0];
  const auto inside = [&](const Vec3& a, const Vec3& b) { return n.dot((b - a).cross(x - whole * a)) * whole > 0; };
  return inside(p[2], p[3]) && inside(p[3], p[4]) && inside(p[4], p[2]);
}

TEST(SegmentTriangle, AgreesWithHullOracleOnTheGrid) {
  Random random(5);
  std::array<int, 3> counts = {};
  for (int i = 0; i < 20000; ++i) {
    std::array<Vec3, 5> p;
    for (Vec3& x : p) x = random.grid_point(1 + i % 4);
    const Crossing contact = segment_triangle_intersect(p[0], p[1], p[2], p[3], p[4]);
    ++counts[static_cast<std::size_t>(contact)];
    EXPECT_EQ(contact != Crossing::none, hulls_meet({p[0], p[1]}, {p[2], p[3], p[4]}));
    EXPECT_EQ(contact == Crossing::proper, crosses_properly(p));
    EXPECT_EQ(contact, segment_triangle_intersect(p[1], p[0], p[4], p[3], p[2]));
  }
  EXPECT_GT(*std::min_element(counts.begin(), counts.end()), 100);
}

TEST(Segments, AgreeWithHullOracleOnTheGrid) {
  Random random(6);
  for (int i = 0; i < 20000; ++i) {
    std::array<Vec3, 4> p;
    for (Vec3& x : p) x = random.grid_point(1 + i % 3);
    if (i % 2 == 0) {
      for (Vec3& x : p) x.z() = 0;
    }
    EXPECT_EQ(segments_intersect(p[0], p[1], p[2], p[3]), hulls_meet({p[0], p[1]}, {p[2], p[3]}));
  }
}

TEST(Triangles, AgreeWithHullOracleOnTheGrid) {
  Random random(7);
  int hits = 0;
  for (int i = 0; i < 4000; ++i) {
    std::array<Vec3, 3> a;
    std::array<Vec3, 3> b;
    const Vec3 apart((i % 3), (i % 2), 0);
    for (Vec3& x : a) x = random.grid_point(2 + i % 3);
    for (Vec3& x : b) x = random.grid_point(2 + i % 3) + apart;
    const Crossing contact = triangles_intersect(a, b);
    hits += contact != Crossing::none ? 1 : 0;
    EXPECT_EQ(contact != Crossing::none, hulls_meet({a[0], a[1], a[2]}, {b[0], b[1], b[2]}));
    EXPECT_EQ(contact, triangles_intersect(b, a));
  }
  EXPECT_GT(hits, 500);
  EXPECT_LT(hits, 3500);
}

TEST(TrianglesSharingAVertex, AgreeWithConeOracleOnTheGrid) {
  // They meet elsewhere when the cones from the shared vertex do: a combination of a1, a2, -b1, -b2 gives zero.
  Random random(8);
  int hits = 0;
  for (int i = 0; i < 10000; ++i) {
    const Vec3 shared = random.grid_point(3);
    std::array<Vec3, 4> p;
    for (Vec3& x : p) x = random.grid_point(3);
    if (collinear(shared, p[0], p[1]) || collinear(shared, p[2], p[3])) continue;
    HullOracle cones;
    cones.add(p[0] - shared);
    cones.add(p[1] - shared);
    cones.add(shared - p[2]);
    cones.add(shared - p[3]);
    const bool meet = triangles_intersect_sharing_vertex(shared, p[0], p[1], p[2], p[3]) != Crossing::none;
    hits += meet ? 1 : 0;
    EXPECT_EQ(meet, cones.holds_origin());
  }
  EXPECT_GT(hits, 500);
}

TEST(SegmentTriangle, NamedCases) {
  const Vec3 a(0, 0, 0);
  const Vec3 b(1, 0, 0);
  const Vec3 c(0, 1, 0);
  const auto contact = [&](const Vec3& s0, const Vec3& s1) { return segment_triangle_intersect(s0, s1, a, b, c); };
  EXPECT_EQ(contact({0.25, 0.25, -1}, {0.25, 0.25, 1}), Crossing::proper);
  EXPECT_EQ(contact({0.25, 0.25, 0}, {0.25, 0.25, 1}), Crossing::touching) << "an end on the face";
  EXPECT_EQ(contact({0.5, 0, -1}, {0.5, 0, 1}), Crossing::touching) << "through an edge";
  EXPECT_EQ(contact({0, 0, -1}, {0, 0, 1}), Crossing::touching) << "through a corner";
  EXPECT_EQ(contact({-1, 0.25, 0}, {2, 0.25, 0}), Crossing::touching) << "in the plane, across";
  EXPECT_EQ(contact({0.1, 0.1, 0}, {0.2, 0.2, 0}), Crossing::touching) << "in the plane, inside";
  EXPECT_EQ(contact({-1, 2, 0}, {2, 2, 0}), Crossing::none) << "in the plane, outside";
  EXPECT_EQ(contact({0.25, 0.25, std::numeric_limits<double>::denorm_min()}, {0.25, 0.25, 1}), Crossing::none);
  EXPECT_EQ(contact({-std::numeric_limits<double>::denorm_min(), 0.25, -1}, {0, 0.25, 1}), Crossing::none);
  EXPECT_EQ(contact(a, a), Crossing::touching) << "a point";
}

TEST(CoplanarOverlap, NamedCases) {
  const Vec3 e0(0, 0, 0);
  const Vec3 e1(1, 0, 0);
  EXPECT_TRUE(coplanar_overlap_sharing_edge(e0, e1, {0.5, 1, 0}, {0.2, 3, 0})) << "folded flat";
  EXPECT_TRUE(coplanar_overlap_sharing_edge(e1, e0, {0.5, 1, 0}, {5, 1e-300, 0}));
  EXPECT_FALSE(coplanar_overlap_sharing_edge(e0, e1, {0.5, 1, 0}, {0.5, -1, 0})) << "flat, on either side";
  EXPECT_FALSE(coplanar_overlap_sharing_edge(e0, e1, {0.5, 1, 0}, {0.5, 1, 1e-300})) << "a wedge";
  EXPECT_FALSE(coplanar_overlap_sharing_edge(e0, e1, {0.5, 1, 0}, {0.5, 0, 0})) << "b on the edge";
  EXPECT_FALSE(coplanar_overlap_sharing_edge(e0, e1, {0.5, 0, 0}, {0.5, 1, 0})) << "a on the edge";
  EXPECT_TRUE(coplanar_overlap_sharing_edge(e0, e1, {2, 0, 0}, {3, 0, 0})) << "both collapsed, past the same end";
  EXPECT_FALSE(coplanar_overlap_sharing_edge(e0, e1, {2, 0, 0}, {-3, 0, 0})) << "both collapsed, past either end";
  EXPECT_TRUE(coplanar_overlap_sharing_edge(e0, e0, {1, 2, 3}, {2, 4, 6})) << "an edge of no length";
  EXPECT_FALSE(coplanar_overlap_sharing_edge(e0, e0, {1, 2, 3}, {2, 4, 7}));
}

}  // namespace
}  // namespace lostopos::test
