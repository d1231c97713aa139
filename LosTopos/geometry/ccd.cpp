#include "LosTopos/geometry/ccd.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "LosTopos/geometry/distance.h"
#include "LosTopos/geometry/moving_hull.h"

namespace lostopos {
namespace {

// Largest components between these keep products of three of them from overflow, and underflow within its bound.
constexpr double smallest_trusted_size = 0x1p-100;
constexpr double largest_trusted_size = 0x1p+20;

// Differences of such differences do not overflow.
constexpr double largest_plain_difference = 0x1p+1020;

// A trajectory with its place among the arguments.
struct Point {
  const Trajectory* trajectory;
  std::size_t place;
};

// By coordinates alone, so that sorted arguments do not depend on the order in which they were given.
int compare(const Trajectory& a, const Trajectory& b) {
  for (int i = 0; i < 3; ++i) {
    if (a.start[i] != b.start[i]) return a.start[i] < b.start[i] ? -1 : 1;
  }
  for (int i = 0; i < 3; ++i) {
    if (a.end[i] != b.end[i]) return a.end[i] < b.end[i] ? -1 : 1;
  }
  return 0;
}

bool less(const Point& a, const Point& b) {
  return compare(*a.trajectory, *b.trajectory) < 0;
}

using Points = std::array<Point, 4>;

Points sorted_triangle(const Trajectory& p, const Trajectory& a, const Trajectory& b, const Trajectory& c) {
  Points points = {{{&p, 0}, {&a, 1}, {&b, 2}, {&c, 3}}};
  if (less(points[2], points[1])) std::swap(points[1], points[2]);
  if (less(points[3], points[2])) std::swap(points[2], points[3]);
  if (less(points[2], points[1])) std::swap(points[1], points[2]);
  return points;
}

Points sorted_edges(const Trajectory& a, const Trajectory& b, const Trajectory& c, const Trajectory& d) {
  Points points = {{{&a, 0}, {&b, 1}, {&c, 2}, {&d, 3}}};
  if (less(points[1], points[0])) std::swap(points[0], points[1]);
  if (less(points[3], points[2])) std::swap(points[2], points[3]);
  const int order = compare(*points[0].trajectory, *points[2].trajectory);
  if (order > 0 || (order == 0 && less(points[3], points[1]))) {
    std::swap(points[0], points[2]);
    std::swap(points[1], points[3]);
  }
  return points;
}

// from - to, with the coordinates scaled first: scaling by 1 leaves the difference rounded once.
MovingVector difference(const Trajectory& from, const Trajectory& to, double scale) {
  return {scale * from.start - scale * to.start, scale * from.end - scale * to.end};
}

MovingHull triangle_hull(const Trajectory& p, const Trajectory& a, const Trajectory& b, const Trajectory& c,
                         double scale = 1) {
  MovingHull hull;
  hull.size = 3;
  hull.corners = {
      difference(a, p, scale), difference(b, p, scale), difference(c, p, scale), {Vec3::Zero(), Vec3::Zero()}};
  hull.e1 = difference(b, a, scale);
  hull.e2 = difference(c, a, scale);
  return hull;
}

MovingHull edges_hull(const Trajectory& a, const Trajectory& b, const Trajectory& c, const Trajectory& d,
                      double scale = 1) {
  MovingHull hull;
  hull.size = 4;
  hull.corners = {difference(c, a, scale), difference(d, a, scale), difference(c, b, scale), difference(d, b, scale)};
  hull.e1 = difference(b, a, scale);
  hull.e2 = difference(d, c, scale);
  return hull;
}

double size_of(const MovingHull& hull) {
  Vec3 size = Vec3::Zero();
  for (std::size_t i = 0; i < static_cast<std::size_t>(hull.size); ++i) {
    size = size.cwiseMax(hull.corners[i].start.cwiseAbs()).cwiseMax(hull.corners[i].end.cwiseAbs());
  }
  return size.maxCoeff();
}

void multiply(MovingHull& hull, double factor) {
  for (MovingVector* v : {&hull.corners[0], &hull.corners[1], &hull.corners[2], &hull.corners[3], &hull.e1, &hull.e2}) {
    v->start *= factor;
    v->end *= factor;
  }
}

// Scales the hull to a size near one, and advances. `rebuild(scale)` makes it anew from scaled coordinates, for those
// whose differences overflow.
template <class Rebuild>
std::optional<HullContact> contact_of(MovingHull& hull, const Rebuild& rebuild) {
  double size = size_of(hull);
  if (!(size < largest_plain_difference)) {
    hull = rebuild(1 / 16.0);
    size = size_of(hull);
  }
  if (size == 0) return HullContact{0, Vec3::Zero()};
  if (!(size >= smallest_trusted_size && size <= largest_trusted_size)) {
    int exponent = 0;
    std::frexp(size, &exponent);
    // Two factors, for 2^-exponent may be too large for one.
    multiply(hull, std::ldexp(1.0, -exponent / 2));
    multiply(hull, std::ldexp(1.0, -exponent - (-exponent / 2)));
  }
  return first_contact_with_origin(hull);
}

Vec3 unit(const Vec3& v) {
  const double size = v.lpNorm<Eigen::Infinity>();
  return size > 0 ? Vec3((v / size).normalized()) : Vec3::Zero();
}

Vec3 displacement(const Point& point) {
  return point.trajectory->end - point.trajectory->start;
}

// Normal and relative displacement of a contact with the given displacement of the first shape's contact point
// relative to the second's.
void set_normal(Collision& collision, const MovingHull& hull, const HullContact& contact, const Vec3& displacement) {
  collision.normal = -unit(contact.direction);
  if (collision.normal.isZero(0)) {
    // In contact from the start.
    collision.normal = unit(hull.e1.start.cross(hull.e2.start));
    if (collision.normal.isZero(0)) collision.normal = unit(-displacement);
    if (collision.normal.isZero(0)) collision.normal = Vec3::UnitX();
    if (collision.normal.dot(displacement) > 0) collision.normal = -collision.normal;
  }
  collision.relative_displacement = collision.normal.dot(displacement);
}

}  // namespace

std::optional<Collision> vertex_triangle_collision(const Trajectory& point, const Trajectory& a, const Trajectory& b,
                                                   const Trajectory& c) {
  if (separated_along_an_axis(triangle_hull(point, a, b, c))) return std::nullopt;
  const Points sorted = sorted_triangle(point, a, b, c);
  const auto build = [&sorted](double scale) {
    return triangle_hull(*sorted[0].trajectory, *sorted[1].trajectory, *sorted[2].trajectory, *sorted[3].trajectory,
                         scale);
  };
  MovingHull hull = build(1);
  const std::optional<HullContact> contact = contact_of(hull, build);
  if (!contact) return std::nullopt;

  const double t = contact->time;
  const Vec3 weights =
      point_triangle_distance(Vec3::Zero(), hull.corners[0].at(t), hull.corners[1].at(t), hull.corners[2].at(t))
          .weights;
  Collision collision;
  collision.time = t;
  collision.weights[0] = 1;
  Vec3 relative = displacement(sorted[0]);
  for (int i = 0; i < 3; ++i) {
    const Point& corner = sorted[static_cast<std::size_t>(i) + 1];
    collision.weights[corner.place] = weights[i];
    relative -= weights[i] * displacement(corner);
  }
  set_normal(collision, hull, *contact, relative);
  return collision;
}

std::optional<Collision> edge_edge_collision(const Trajectory& a, const Trajectory& b, const Trajectory& c,
                                             const Trajectory& d) {
  if (separated_along_an_axis(edges_hull(a, b, c, d))) return std::nullopt;
  const Points sorted = sorted_edges(a, b, c, d);
  const auto build = [&sorted](double scale) {
    return edges_hull(*sorted[0].trajectory, *sorted[1].trajectory, *sorted[2].trajectory, *sorted[3].trajectory,
                      scale);
  };
  MovingHull hull = build(1);
  const std::optional<HullContact> contact = contact_of(hull, build);
  if (!contact) return std::nullopt;

  const double t = contact->time;
  const SegmentSegmentDistance nearest =
      segment_segment_distance(Vec3::Zero(), hull.e1.at(t), hull.corners[0].at(t), hull.corners[1].at(t));
  const std::array<double, 4> weights = {1 - nearest.s, nearest.s, 1 - nearest.t, nearest.t};
  Collision collision;
  collision.time = t;
  Vec3 relative = Vec3::Zero();
  for (std::size_t i = 0; i < 4; ++i) {
    collision.weights[sorted[i].place] = weights[i];
    relative += (i < 2 ? weights[i] : -weights[i]) * displacement(sorted[i]);
  }
  set_normal(collision, hull, *contact, relative);
  if (sorted[0].place > 1) collision.normal = -collision.normal;
  return collision;
}

}  // namespace lostopos
